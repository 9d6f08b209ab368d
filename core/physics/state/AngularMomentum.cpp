#include "core/physics/state/AngularMomentum.h"

namespace rubble {
namespace {

constexpr float kFastAngle = 0.02f;      // rad per step
constexpr float kFlyingAngle = 0.0002f;  // rad per step, without contacts, which would damp the error
constexpr int kMidpointIterations = 6;   // fixed-point iterations; each multiplies the error by the angle of a sub-step

/// q advanced by angular velocity w over the time 2 * half, to first order, normalized.
Quatf advanced(const Quatf& q, Vec3f w, float half) {
    const Vec3f t = w * half;
    return Quatf{q.x + t.x * q.w + t.y * q.z - t.z * q.y, q.y - t.x * q.z + t.y * q.w + t.z * q.x,
                 q.z + t.x * q.y - t.y * q.x + t.z * q.w, q.w - t.x * q.x - t.y * q.y - t.z * q.z}
        .normalized();
}

Vec3f angularVelocityOf(const Body& body, const Quatf& rotation, Vec3f momentum) {
    const Mat3f matrix = rotation.matrix();
    return matrix * (body.inverseInertia * matrix.transposedTimes(momentum));
}

}  // namespace

Vec3f angularMomentum(const WorldState& state, std::uint32_t number) {
    const Body& body = state.bodies[number];
    const Mat3f rotation = state.poses[number].rotation.matrix();
    return body.angularMomentum +
           rotation * (body.inertia *
                       rotation.transposedTimes(state.motions[number].angularVelocity - body.referenceAngularVelocity));
}

bool isFastRotating(const WorldState& state, std::uint32_t body, float dt) {
    const float least = state.bodies[body].firstContact == kNone ? kFlyingAngle : kFastAngle;
    return state.bodies[body].isDynamic() &&
           lengthSquared(state.motions[body].angularVelocity) * dt * dt > least * least;
}

Quatf midpointRotation(const WorldState& state, std::uint32_t number, float h) {
    const Body& body = state.bodies[number];
    const BodyPose& pose = state.poses[number];
    const BodyMotion& motion = state.motions[number];
    const Vec3f momentum = angularMomentum(state, number);
    const Quatf start = motion.deltaRotation;
    Quatf end = advanced(start, angularVelocityOf(body, start * pose.rotation, momentum), 0.5f * h);
    for (int round = 0; round < kMidpointIterations; ++round) {
        const Quatf middle = Quatf{start.x + end.x, start.y + end.y, start.z + end.z, start.w + end.w}.normalized();
        end = advanced(start, angularVelocityOf(body, middle * pose.rotation, momentum), 0.5f * h);
    }
    return end;
}

void applyRotation(WorldState& state, std::uint32_t number) {
    Body& body = state.bodies[number];
    BodyPose& pose = state.poses[number];
    BodyMotion& motion = state.motions[number];
    const Quatf rotation = (motion.deltaRotation * pose.rotation).normalized();
    if (body.isDynamic()) {
        body.angularMomentum = angularMomentum(state, number);
        body.referenceAngularVelocity = motion.angularVelocity =
            angularVelocityOf(body, rotation, body.angularMomentum);
        pose.inverseInertia = rotated(body.inverseInertia, rotation.matrix());
    }
    pose.rotation = rotation;
}

}  // namespace rubble
