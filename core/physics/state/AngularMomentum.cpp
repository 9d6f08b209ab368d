#include "core/physics/state/AngularMomentum.h"

#include "core/base/Assert.h"
#include "core/physics/state/TorqueFree.h"

namespace rubble {
namespace {

constexpr float kFastAngle = 0.02f;      // rad per step
constexpr float kFlyingAngle = 0.0002f;  // rad per step, without contacts, which would damp the error
constexpr float kSmallAngle = 0.001f;    // rad per step: the angular velocity is constant in the body's axes

/// Whether the stored angular momentum is that of the body: nothing has changed its angular velocity since.
bool isKnown(const Body& body, const BodyMotion& motion) {
    return motion.angularVelocity == body.referenceAngularVelocity;
}

Vec3f angularMomentumOf(const Body& body, const Quatf& rotation, Vec3f angularVelocity) {
    const Mat3f matrix = rotation.matrix();
    return matrix * (body.inertia * matrix.transposedTimes(angularVelocity));
}

Quatf currentRotation(const BodyPose& pose, const BodyMotion& motion) {
    return (motion.deltaRotation * pose.rotation).normalized();
}

/// The angular velocity that belongs to the stored angular momentum, in the body's axes.
Vec3f freeAngularVelocity(const Body& body, const Quatf& rotation) {
    return body.inverseInertia * rotation.matrix().transposedTimes(body.angularMomentum);
}

/// The angular velocity at the end of the step, in the body's axes, of a body that was touched or rotates slowly. The
/// solver's is that at the beginning of the step, and so are the arms of its impulses. Impulses therefore count as if
/// applied at the beginning: in the body's axes the energy is the one that the solver saw, and the torque-free motion
/// since then conserves it. It takes the sub-steps of rotateFreely(), so that a body that was hardly touched hardly
/// changes its angular momentum.
Vec3f finalAngularVelocity(const Body& body, const BodyPose& pose, Vec3f angularVelocity, int subSteps, float h) {
    TorqueFreeMotion motion{{}, pose.rotation.matrix().transposedTimes(angularVelocity)};
    const float dt = h * static_cast<float>(subSteps);
    if (lengthSquared(angularVelocity) * dt * dt < kSmallAngle * kSmallAngle) return motion.angularVelocity;
    if (!body.isFastRotating) return advanced(body, motion, dt).angularVelocity;
    for (int k = 0; k < subSteps; ++k) motion = advanced(body, motion, h);
    return motion.angularVelocity;
}

bool rotatesFast(const WorldState& state, std::uint32_t body, float dt) {
    const float least = state.bodies[body].firstContact == kNone ? kFlyingAngle : kFastAngle;
    return state.bodies[body].isDynamic() &&
           lengthSquared(state.motions[body].angularVelocity) * dt * dt > least * least;
}

}  // namespace

Vec3f angularMomentum(const WorldState& state, std::uint32_t number) {
    const Body& body = state.bodies[number];
    const Vec3f angularVelocity = state.motions[number].angularVelocity;
    if (isKnown(body, state.motions[number])) return body.angularMomentum;
    return angularMomentumOf(body, state.poses[number].rotation, angularVelocity);
}

bool beginRotation(WorldState& state, std::uint32_t number, float dt) {
    Body& body = state.bodies[number];
    body.isFastRotating = rotatesFast(state, number, dt);
    body.isTouched = false;
    if (body.isFastRotating) {
        body.angularMomentum = angularMomentum(state, number);
        body.referenceAngularVelocity = state.motions[number].angularVelocity;
    }
    return body.isFastRotating;
}

void rotateFreely(WorldState& state, std::uint32_t number, float h) {
    Body& body = state.bodies[number];
    RUBBLE_ASSERT(body.isFastRotating);
    const BodyPose& pose = state.poses[number];
    BodyMotion& motion = state.motions[number];
    const Quatf rotation = currentRotation(pose, motion);
    Vec3f velocity = freeAngularVelocity(body, rotation);
    if (!isKnown(body, motion)) {
        const Vec3f change = motion.angularVelocity - body.referenceAngularVelocity;
        velocity += pose.rotation.matrix().transposedTimes(change);
        body.angularMomentum = rotation.matrix() * (body.inertia * velocity);
        body.referenceAngularVelocity = motion.angularVelocity;
        body.isTouched = true;
    }
    motion.deltaRotation = advanced(body, {rotation, velocity}, h).rotation * pose.rotation.conjugate();
}

void applyRotation(WorldState& state, std::uint32_t number, int subSteps, float h) {
    Body& body = state.bodies[number];
    BodyPose& pose = state.poses[number];
    BodyMotion& motion = state.motions[number];
    const Quatf rotation = currentRotation(pose, motion);
    if (body.isDynamic()) {
        const Mat3f matrix = rotation.matrix();
        const bool isFree = body.isFastRotating && !body.isTouched && isKnown(body, motion);
        const Vec3f velocity = isFree ? freeAngularVelocity(body, rotation)
                                      : finalAngularVelocity(body, pose, motion.angularVelocity, subSteps, h);
        motion.angularVelocity = matrix * velocity;
        if (!isFree) body.angularMomentum = matrix * (body.inertia * velocity);
        body.referenceAngularVelocity = motion.angularVelocity;
        pose.inverseInertia = rotated(body.inverseInertia, matrix);
    }
    pose.rotation = rotation;
}

}  // namespace rubble
