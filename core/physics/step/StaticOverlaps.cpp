#include "core/physics/step/StaticOverlaps.h"

#include "core/physics/state/Contacts.h"
#include "core/physics/step/Displacement.h"
#include "core/physics/step/NarrowPhase.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr float kMinDepth = 0.0025f;      // m
constexpr float kWidthFraction = 0.125f;  // of a body's width
constexpr int kRounds = 4;                // where several push

/// The pose of a body at the end of the step.
BodyPose poseAfter(const WorldState& state, std::uint32_t number) {
    BodyPose pose = state.poses[number];
    pose.centre += state.motions[number].deltaPosition;
    pose.rotation = (state.motions[number].deltaRotation * pose.rotation).normalized();
    return pose;
}

/// How deep two hulls overlap, m, where that is more than `least`: else a smaller number; and the axis.
SeparatingAxis overlapOf(const Hull& body, const Hull& other, const RelativePose& pose, float least) {
    return separatingAxis(body, other, pose, -least, initialGuess(body, other, pose));
}

/// An upper bound of how far the points of a body move in the step, m.
float reachOf(const WorldState& state, std::uint32_t number) {
    const BodyMotion& motion = state.motions[number];
    return length(motion.deltaPosition) +
           2.0f * length(motion.deltaRotation.vector()) * state.poses[number].boundingRadius;
}

/// The least separation of the points of a contact at the beginning of the step, m; of one without, a lower bound.
float separationBefore(const WorldState& state, const Contact& contact) {
    if (!contact.slot.isSet()) {
        const float travel = state.poses[contact.bodies[0]].travel + state.poses[contact.bodies[1]].travel;
        return state.separated[contact.separatedIndex].collideAtTravel - travel;
    }
    const ContactBlock& block = state.colours.block(contact.slot);
    const auto lane = static_cast<std::size_t>(ContactColours::laneOf(contact.slot));
    float least = 0.0f;
    for (std::size_t i = 0; i < block.pointCount[lane]; ++i) least = std::min(least, block.points[i].separation[lane]);
    return least;
}

/// What moves a body out of another, m; zero if it is not too deep.
Vec3f wayOut(const WorldState& state, std::uint32_t number, std::uint32_t other, const Contact& contact) {
    const std::size_t side = contact.bodies[0] == number ? 0 : 1;
    const PlacedHull& placed = placedHullOf(state, state.proxies[contact.proxies[side]]);
    const PlacedHull& otherPlaced = placedHullOf(state, state.proxies[contact.proxies[1 - side]]);
    const float allowed = std::max(kMinDepth, kWidthFraction * state.bodies[number].shape->minWidth);
    const BodyPose pose = poseAfter(state, number);
    const RelativePose after = relativePose(pose, placed.offset, poseAfter(state, other), otherPlaced.offset);
    const SeparatingAxis axis = overlapOf(*placed.hull, *otherPlaced.hull, after, allowed);
    if (axis.separation >= -allowed) return Vec3f(0.0f);
    const RelativePose before =
        relativePose(state.poses[number], placed.offset, state.poses[other], otherPlaced.offset);
    const float depthBefore = -overlapOf(*placed.hull, *otherPlaced.hull, before, allowed).separation;
    const float depth = -axis.separation - std::max(allowed, depthBefore);
    return depth > 0.0f ? pose.rotation.matrix() * axis.normal * -depth : Vec3f(0.0f);
}

/// Returns whether it moved the body.
bool displace(WorldState& state, std::uint32_t number) {
    bool isDisplaced = false;
    const float reach = reachOf(state, number);
    visitContacts(state, number, [&](std::uint32_t contact, std::uint32_t other) {
        const Contact& one = state.contacts[contact];
        if (state.bodies[other].isDynamic()) return;
        if (separationBefore(state, one) - reach - reachOf(state, other) > -kMinDepth) return;
        const Vec3f way = wayOut(state, number, other, one);
        if (way == Vec3f(0.0f)) return;
        correctDisplacement(state, number, state.motions[number].deltaPosition + way);
        isDisplaced = true;
    });
    return isDisplaced;
}

}  // namespace

void displaceOutOfStatic(WorldState& state, ThreadPool& threads, const Regions& regions) {
    regions.forEach(threads, [&](std::size_t region) {
        for (const std::uint32_t number : regions.bodies(region)) {
            if (!state.bodies[number].isDynamic()) continue;
            for (int round = 0; round < kRounds && displace(state, number); ++round) {}
        }
    });
}

}  // namespace rubble
