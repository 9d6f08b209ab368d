#include "core/physics/step/ContinuousCollision.h"

#include "core/physics/narrowphase/HullRay.h"
#include "core/physics/state/Contacts.h"
#include "core/physics/step/Displacement.h"
#include "core/physics/step/NarrowPhase.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr float kFastFraction = 0.5f;  // of a body's width: with a smaller displacement it cannot tunnel
// Distance, relative to a hull's width, at which its middle stops before the surface, if the hull reaches so far: what
// does not touch is not stopped by a contact. On the surface itself, the axis of least overlap could lead out through
// the far side.
constexpr float kDistanceFraction = 0.25f;

Mat3f endRotation(const WorldState& state, std::uint32_t body) {
    return (state.motions[body].deltaRotation * state.poses[body].rotation).normalized().matrix();
}

/// The movement of a point of a body: from its centre before the step and after it.
struct PointPath {
    Vec3f before, after;
};

/// The path of a point inside a hull of a body. The body's own centre may be in none of its hulls.
PointPath pathOf(const WorldState& state, std::uint32_t body, const PlacedHull& placed) {
    const Vec3f point = placed.offset + placed.hull->mean;
    return {state.poses[body].centre + state.poses[body].rotation.matrix() * point,
            state.poses[body].centre + state.motions[body].deltaPosition + endRotation(state, body) * point};
}

/// The same, in the frame of another body, which moves.
PointPath pathPast(const WorldState& state, const PointPath& path, std::uint32_t other) {
    const BodyPose& pose = state.poses[other];
    return {pose.rotation.matrix().transposedTimes(path.before - pose.centre),
            endRotation(state, other).transposedTimes(path.after - pose.centre - state.motions[other].deltaPosition)};
}

/// Whether a point of a path comes as near to a body as the body reaches. In the frame of a body that spins, a path is
/// a chord: it may lead through what the point never comes near.
bool comesNear(const WorldState& state, const PointPath& path, std::uint32_t other) {
    const Vec3f from = path.before - state.poses[other].centre;
    const Vec3f way = path.after - path.before - state.motions[other].deltaPosition;
    const float size = lengthSquared(way);
    const Vec3f nearest = from + way * (size > 0.0f ? std::clamp(-dot(from, way) / size, 0.0f, 1.0f) : 0.0f);
    const float radius = state.poses[other].boundingRadius;
    return lengthSquared(nearest) <= radius * radius;
}

bool isLighter(const WorldState& state, std::uint32_t body, std::uint32_t other) {
    return state.bodies[body].isDynamic() && state.bodies[body].mass < state.bodies[other].mass;
}

/// Takes the speed at which a body approaches another along a normal of it, which points out. Where they overlap
/// already, their contact is along another axis, and would never stop them.
void stopApproach(WorldState& state, std::uint32_t body, std::uint32_t other, Vec3f normal) {
    BodyMotion &own = state.motions[body], &others = state.motions[other];
    const float speed = dot(own.velocity - others.velocity, normal);
    if (speed >= 0.0f) return;
    const Vec3f impulse = normal * (-speed / (own.inverseMass + others.inverseMass));
    own.velocity += impulse * own.inverseMass;
    others.velocity -= impulse * others.inverseMass;
}

/// Clamps the displacement of a body at the other body of a contact.
void clampDisplacement(WorldState& state, const BodyContact& one, std::vector<BodyPair>& clamped) {
    const auto [body, number, other] = one;
    const Contact& contact = state.contacts[number];
    const std::size_t side = contact.bodies[0] == other ? 0 : 1;
    const PlacedHull& placed = placedHullOf(state, state.proxies[contact.proxies[side]]);
    const PlacedHull& own = placedHullOf(state, state.proxies[contact.proxies[1 - side]]);
    const PointPath path = pathOf(state, body, own);
    if (!comesNear(state, path, other)) return;
    const PointPath past = pathPast(state, path, other);
    const Vec3f displacement = past.after - past.before;
    const HullRayHit hit = castRay(*placed.hull, past.before - placed.offset, displacement);
    if (hit.fraction > 1.0f) return;
    clamped.push_back({body, other});
    const float distance = kDistanceFraction * own.hull->minWidth;
    const float fraction = std::max(0.0f, hit.fraction + distance / dot(hit.normal, displacement));
    // The stopping point, as it has moved with the other body by the end of the step: unless that spins, and would
    // carry the body farther than it moves.
    const Vec3f kept = state.poses[other].centre + state.motions[other].deltaPosition +
                       endRotation(state, other) * (past.before + displacement * fraction);
    const Vec3f moved = state.motions[body].deltaPosition;
    Vec3f stopped = moved + kept - path.after;
    if (isLighter(state, other, body) || lengthSquared(stopped) > lengthSquared(moved))
        stopped = moved * std::clamp(fraction, 0.0f, 1.0f);
    if (contact.slot.isSet() && !isApart(state, contact))
        stopApproach(state, body, other, state.poses[other].rotation.matrix() * hit.normal);
    if (state.bodies[other].isDynamic()) {
        state.motions[body].deltaPosition = stopped;
    } else {
        correctDisplacement(state, body, stopped);
    }
}

}  // namespace

std::vector<BodyPair> clampFastBodies(WorldState& state, ThreadPool& threads, const Regions& regions,
                                      ContinuousScratch& scratch) {
    clearLists(scratch.fast, regions.count());
    regions.forEach(threads, [&](std::size_t region) {
        for (std::uint32_t number : regions.bodies(region)) {
            const Body& body = state.bodies[number];
            const float limit = kFastFraction * body.shape->minWidth;
            const bool isFast = lengthSquared(state.motions[number].deltaPosition) > limit * limit;
            if (isFast && body.isDynamic()) scratch.fast[region].push_back(number);
        }
    });
    std::vector<BodyPair> clamped;
    const auto isInTheWay = [&](std::uint32_t body, std::uint32_t other, const SeparatedContact* separated) {
        return state.isSwept(body, other) && (separated == nullptr || mayHaveTouched(state, *separated));
    };
    const std::span<const BodyContact> contacts = scratch.contacts.of(state, mergeSorted(scratch.fast), isInTheWay);
    for (const bool isDynamic : {true, false}) {  // what is fixed last: others may carry bodies into it
        for (const BodyContact& one : contacts) {
            if (state.bodies[one.other].isDynamic() == isDynamic) clampDisplacement(state, one, clamped);
        }
    }
    return clamped;
}

}  // namespace rubble
