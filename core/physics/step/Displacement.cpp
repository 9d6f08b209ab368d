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

float reachOf(const WorldState& state, std::uint32_t number) {
    const BodyMotion& motion = state.motions[number];
    return length(motion.deltaPosition) +
           2.0f * length(motion.deltaRotation.vector()) * state.poses[number].boundingRadius;
}

float maxReachOf(const WorldState& state, std::uint32_t number) {
    const BodyMotion& motion = state.motions[number];
    const auto sum = [](Vec3f v) { return std::abs(v.x) + std::abs(v.y) + std::abs(v.z); };
    return sum(motion.deltaPosition) + 2.0f * sum(motion.deltaRotation.vector()) * state.poses[number].boundingRadius;
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
