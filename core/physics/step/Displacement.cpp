#include "core/physics/step/Displacement.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

/// J.
float kineticEnergy(const WorldState& state, std::uint32_t number) {
    const Body& body = state.bodies[number];
    const BodyMotion& motion = state.motions[number];
    const Vec3f spin = state.poses[number].rotation.matrix().transposedTimes(motion.angularVelocity);
    return 0.5f * (body.mass * lengthSquared(motion.velocity) + dot(spin, body.inertia * spin));
}

}  // namespace

BodyPose poseAfter(const WorldState& state, std::uint32_t number) {
    BodyPose pose = state.poses[number];
    pose.centre += state.motions[number].deltaPosition;
    pose.rotation = (state.motions[number].deltaRotation * pose.rotation).normalized();
    return pose;
}

float arcOf(const WorldState& state, std::uint32_t number) {
    return 2.0f * length(state.motions[number].deltaRotation.vector()) * state.poses[number].boundingRadius;
}

float reachOf(const WorldState& state, std::uint32_t number) {
    return length(state.motions[number].deltaPosition) + arcOf(state, number);
}

float maxReachOf(const WorldState& state, std::uint32_t number) {
    const BodyMotion& motion = state.motions[number];
    const auto sum = [](Vec3f v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); };
    return sum(motion.deltaPosition) + 2.0f * sum(motion.deltaRotation.vector()) * state.poses[number].boundingRadius;
}

bool mayHaveTouched(const WorldState& state, const SeparatedContact& contact) {
    const auto [first, second] = contact.bodies;
    const BodyPose &a = state.poses[first], &b = state.poses[second];
    const Vec3f way = state.motions[second].deltaPosition - state.motions[first].deltaPosition;
    const float apart = dot(contact.gapNormal, b.centre - a.centre) + std::min(0.0f, dot(contact.gapNormal, way));
    return apart - a.arc - arcOf(state, first) - b.arc - arcOf(state, second) <= contact.apart;
}

void correctDisplacement(WorldState& state, std::uint32_t number, Vec3f displacement) {
    BodyMotion& motion = state.motions[number];
    const float gain = -state.bodies[number].mass * dot(state.gravity, displacement - motion.deltaPosition);  // J
    motion.deltaPosition = displacement;
    if (!(gain > 0.0f)) return;
    const float kinetic = kineticEnergy(state, number);
    const float scale = kinetic > gain ? std::sqrt(1.0f - gain / kinetic) : 0.0f;
    motion.velocity *= scale;
    motion.angularVelocity *= scale;
}

}  // namespace rubble
