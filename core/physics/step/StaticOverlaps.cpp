#include "core/physics/step/StaticOverlaps.h"

#include "core/physics/narrowphase/HullRay.h"
#include "core/physics/state/Contacts.h"
#include "core/physics/step/Displacement.h"
#include "core/physics/step/NarrowPhase.h"

#include <algorithm>

namespace rubble {
namespace {

// How deep bodies may be: thin ones less, so that their centres stay outside.
constexpr float kMinDepth = 0.0005f, kMaxDepth = 0.004f;  // m
constexpr float kWidthFraction = 0.4f;
constexpr float kOutSpeed = 0.1f;      // m/s: of what is deeper already
constexpr float kMinReach = 0.00025f;  // m: what moves less comes no deeper
constexpr float kRounding = 5e-7f;     // of positions, relative, with that of their sums
constexpr int kRounds = 4;             // of displacements, where several bodies displace one

/// Whether the bodies of a contact may come to overlap, or overlap deeper, while they move by `reach`, m. A manifold
/// that is recycled says nothing of other corners.
bool mayOverlap(const WorldState& state, const Contact& contact, float reach) {
    if (contact.slot.isSet()) return true;
    const float travel = state.poses[contact.bodies[0]].travel + state.poses[contact.bodies[1]].travel;
    return travel + reach >= state.separated[contact.separatedIndex].collideAtTravel;
}

/// A contact of a body with one that is not dynamic.
struct StaticContact {
    const PlacedHull& hull;
    std::uint32_t other = 0;  // body
    const PlacedHull& otherHull;
};

/// The axis of least overlap at poses of both bodies, in the frame of the first: any along which they overlap by less
/// than `depth`, m, if there is one.
SeparatingAxis overlapOf(const StaticContact& contact, const BodyPose& body, const BodyPose& other, float depth) {
    const RelativePose pose = relativePose(body, contact.hull.offset, other, contact.otherHull.offset);
    const Hull &first = *contact.hull.hull, &second = *contact.otherHull.hull;
    return separatingAxis(first, second, pose, -depth, initialGuess(first, second, pose));
}

/// What moves a body out of another, m; zero if it is not too deep.
struct WayOut {
    Vec3f way{0.0f, 0.0f, 0.0f};
    bool isThrough = false;  // it would bring the hull to the other side
};

/// Whether the middle of a hull passes through another on its way from before the step to after it and on.
bool passesThrough(const WorldState& state, std::uint32_t number, const StaticContact& contact, const BodyPose& after,
                   Vec3f way) {
    const Vec3f middle = contact.hull.offset + contact.hull.hull->mean;
    const auto inOther = [&](const BodyPose& body, const BodyPose& other) {
        const Vec3f at = body.centre + body.rotation.matrix() * middle;
        return other.rotation.matrix().transposedTimes(at - other.centre) - contact.otherHull.offset;
    };
    BodyPose last = after;
    last.centre += way;
    const Vec3f from = inOther(state.poses[number], state.poses[contact.other]);
    const Vec3f to = inOther(last, poseAfter(state, contact.other));
    return castRay(*contact.otherHull.hull, from, to - from).fraction <= 1.0f;
}

WayOut wayOut(const WorldState& state, std::uint32_t number, const StaticContact& contact, const SolverStep& step) {
    const float most = std::clamp(kWidthFraction * contact.hull.hull->minWidth, kMinDepth, kMaxDepth);
    const BodyPose pose = poseAfter(state, number);
    const SeparatingAxis axis = overlapOf(contact, pose, poseAfter(state, contact.other), most);
    if (axis.separation >= -most) return {};
    const SeparatingAxis before = overlapOf(contact, state.poses[number], state.poses[contact.other], most);
    const float allowed = std::max(most, -before.separation - kOutSpeed * step.dt);
    const Vec3f size = componentAbs(pose.centre);
    const float rounding = kRounding * std::max({1.0f, size.x, size.y, size.z});
    if (axis.separation >= -allowed - rounding) return {};
    const Vec3f way = pose.rotation.matrix() * axis.normal * (axis.separation + allowed);
    return {way, passesThrough(state, number, contact, pose, way)};
}

/// Calls visit(way) for what moves a body out of what is not dynamic, one after the other.
template <class Visit>
void visitWaysOut(WorldState& state, std::uint32_t number, const SolverStep& step, const Visit& visit) {
    const float reach = reachOf(state, number);
    visitContacts(state, number, [&](std::uint32_t index, std::uint32_t other) {
        const Contact& contact = state.contacts[index];
        if (state.bodies[other].isDynamic()) return;
        if (!mayOverlap(state, contact, reach + reachOf(state, other))) return;
        const std::size_t side = contact.bodies[0] == number ? 0 : 1;
        const StaticContact one{placedHullOf(state, state.proxies[contact.proxies[side]]), other,
                                placedHullOf(state, state.proxies[contact.proxies[1 - side]])};
        const WayOut way = wayOut(state, number, one, step);
        if (way.way == Vec3f(0.0f)) return;
        if (contact.slot.isSet()) outdateManifold(state, contact);
        visit(way);
    });
}

/// Returns whether nothing displaces the body any more.
bool displace(WorldState& state, std::uint32_t number, const SolverStep& step) {
    for (int round = 0; round < kRounds; ++round) {
        bool isOut = true;
        bool isThrough = false;
        visitWaysOut(state, number, step, [&](const WayOut& way) {
            correctDisplacement(state, number, state.motions[number].deltaPosition + way.way);
            isOut = false;
            isThrough |= way.isThrough;
        });
        if (isOut || isThrough) return isOut;
    }
    return false;
}

/// Lets a body move by the largest of some fractions of what it moved that leaves it out of what is not dynamic.
void shorten(WorldState& state, std::uint32_t number, const SolverStep& step, const BodyMotion& moved) {
    const Quatf turned = moved.deltaRotation.normalized();
    for (const float fraction : {0.5f, 0.25f, 0.0f}) {
        state.motions[number].deltaRotation =
            Quatf{turned.x * fraction, turned.y * fraction, turned.z * fraction, 1.0f - fraction + turned.w * fraction}
                .normalized();
        correctDisplacement(state, number, moved.deltaPosition * fraction);
        bool isOut = true;
        visitWaysOut(state, number, step, [&](const WayOut&) { isOut = false; });
        if (isOut) return;
    }
}

/// A walk over the contacts of a body takes as long as markNearStatic() for so many.
constexpr std::size_t kContactsPerWalk = 64;

/// Marks the bodies that have contacts with what is not dynamic: most have none.
void markNearStatic(const WorldState& state, std::vector<std::uint8_t>& isNear) {
    isNear.assign(state.bodies.size(), 0);
    for (const ContactColours::List& list : state.colours.lists()) {
        for (const ContactBlock& block : list.blocks) {
            for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
                if (block.againstFixed[lane] != 0.0f) isNear[block.first[lane]] = isNear[block.second[lane]] = 1;
            }
        }
    }
    for (const SeparatedContact& contact : state.separated) {
        const auto [first, second] = contact.bodies;
        const bool isDynamic = state.motions[first].inverseMass > 0.0f && state.motions[second].inverseMass > 0.0f;
        if (!isDynamic) isNear[first] = isNear[second] = 1;
    }
}

}  // namespace

void displaceOutOfStatic(WorldState& state, ThreadPool& threads, const Regions& regions, const SolverStep& step,
                         std::vector<std::uint8_t>& isNear) {
    const auto moves = [&](std::uint32_t number) {
        return maxReachOf(state, number) > kMinReach && state.bodies[number].isDynamic();
    };
    const auto moving = static_cast<std::size_t>(std::ranges::count_if(state.awake, moves));
    if (moving == 0) return;
    const bool isMarked = moving * kContactsPerWalk > state.colours.contactCount() + state.separated.size();
    if (isMarked) markNearStatic(state, isNear);
    regions.forEach(threads, [&](std::size_t region) {
        for (const std::uint32_t number : regions.bodies(region)) {
            if ((isMarked && isNear[number] == 0) || !moves(number)) continue;
            const BodyMotion moved = state.motions[number];
            if (!displace(state, number, step)) shorten(state, number, step, moved);
        }
    });
}

}  // namespace rubble
