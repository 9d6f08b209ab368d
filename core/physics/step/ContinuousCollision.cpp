#include "core/physics/step/ContinuousCollision.h"

#include "core/physics/narrowphase/HullRay.h"
#include "core/physics/state/Contacts.h"
#include "core/physics/step/Displacement.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr float kFastFraction = 0.5f;  // of a body's width: with a smaller displacement it cannot tunnel
// Distance, relative to a body's width, at which its centre stops before the surface. On the surface itself, the axis
// of least overlap could lead out through the far side.
constexpr float kDistanceFraction = 0.25f;

/// The movement of a point, in the frame of a moving body.
struct RelativeDisplacement {
    Vec3f from;
    Vec3f displacement;
};

Mat3f endRotation(const WorldState& state, std::uint32_t body) {
    return (state.motions[body].deltaRotation * state.poses[body].rotation).matrix();
}

RelativeDisplacement displacementPast(const WorldState& state, std::uint32_t body, std::uint32_t other) {
    const BodyPose& pose = state.poses[other];
    const Vec3f before = state.poses[body].centre - pose.centre;
    const Vec3f after = before + state.motions[body].deltaPosition - state.motions[other].deltaPosition;
    const Vec3f from = pose.rotation.matrix().transposedTimes(before);
    return {from, endRotation(state, other).transposedTimes(after) - from};
}

bool isLighter(const WorldState& state, std::uint32_t body, std::uint32_t other) {
    return state.bodies[body].isDynamic() && state.bodies[body].mass < state.bodies[other].mass;
}

/// Clamps the displacement of a body at others that are dynamic, or at those that are not.
void clampDisplacement(WorldState& state, std::uint32_t body, bool isDynamic, std::vector<BodyPair>& clamped) {
    visitContacts(state, body, [&](std::uint32_t number, std::uint32_t other) {
        if (state.bodies[other].isDynamic() != isDynamic) return;
        const Contact& contact = state.contacts[number];
        const Proxy& proxy = state.proxies[contact.proxies[contact.bodies[0] == other ? 0 : 1]];
        const RelativeDisplacement displacement = displacementPast(state, body, other);
        const PlacedHull& placed = placedHullOf(state, proxy);
        const HullRayHit hit = castRay(*placed.hull, displacement.from - placed.offset, displacement.displacement);
        if (hit.fraction > 1.0f) return;
        clamped.push_back({body, other});
        const float distance = kDistanceFraction * state.bodies[body].shape->minWidth;
        const float fraction = std::max(0.0f, hit.fraction + distance / dot(hit.normal, displacement.displacement));
        // The stopping point, as it has moved with the other body by the end of the step: unless that spins, and would
        // carry the body farther than it moves.
        const Vec3f kept = endRotation(state, other) * (displacement.from + displacement.displacement * fraction);
        const Vec3f moved = state.motions[body].deltaPosition;
        Vec3f stopped =
            state.poses[other].centre - state.poses[body].centre + state.motions[other].deltaPosition + kept;
        if (isLighter(state, other, body) || lengthSquared(stopped) > lengthSquared(moved))
            stopped = moved * std::clamp(fraction, 0.0f, 1.0f);
        if (isDynamic) {
            state.motions[body].deltaPosition = stopped;
        } else {
            correctDisplacement(state, body, stopped);
        }
    });
}

}  // namespace

std::vector<BodyPair> clampFastBodies(WorldState& state, ThreadPool& threads, const Regions& regions,
                                      std::vector<std::vector<std::uint32_t>>& byRegion) {
    clearLists(byRegion, regions.count());
    regions.forEach(threads, [&](std::size_t region) {
        for (std::uint32_t number : regions.bodies(region)) {
            const Body& body = state.bodies[number];
            const float limit = kFastFraction * body.shape->minWidth;
            const bool isFast = lengthSquared(state.motions[number].deltaPosition) > limit * limit;
            if (isFast && body.isDynamic()) byRegion[region].push_back(number);
        }
    });
    std::vector<std::uint32_t>& fast = mergeSorted(byRegion);
    std::vector<BodyPair> clamped;
    for (const bool isDynamic : {true, false}) {  // what is fixed last: others may carry bodies into it
        for (const std::uint32_t body : fast) clampDisplacement(state, body, isDynamic, clamped);
    }
    return clamped;
}

}  // namespace rubble
