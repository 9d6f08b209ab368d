#include "core/physics/state/AngularMomentum.h"

#include "core/physics/state/TorqueFree.h"

#include <limits>

namespace rubble {
namespace {

constexpr float kFastAngle = 0.02f;      // rad per step
constexpr float kFlyingAngle = 0.0002f;  // rad per step, without contacts, which would damp the error
constexpr float kResting = 0.00005f;  // rad per sub-step: below it the angular velocity is constant in the body's axes

/// Whether the stored angular momentum is that of the body: nothing has changed its angular velocity since.
bool isUntouched(const Body& body, const BodyMotion& motion) {
    return motion.angularVelocity == body.referenceAngularVelocity;
}

/// The angular velocity, in the body's axes, to an angular momentum in world axes.
Vec3f angularVelocityOf(const Body& body, const Mat3f& rotation, Vec3f momentum) {
    return body.inverseInertia * rotation.transposedTimes(momentum);
}

/// The angular velocity in the body's axes, `count` sub-steps of h seconds into the step. The solver's is that at the
/// beginning of the step, and so are the arms of its impulses. Impulses therefore count as if applied at the beginning:
/// in the body's axes the energy is the one that the solver saw, and the torque-free motion since then conserves it.
/// The sub-steps are those of rotateFreely(), so that a body which was hardly touched hardly changes its angular
/// momentum.
Vec3f angularVelocityInBody(const WorldState& state, std::uint32_t number, int count, float h) {
    const Body& body = state.bodies[number];
    const BodyPose& pose = state.poses[number];
    const BodyMotion& motion = state.motions[number];
    if (isUntouched(body, motion)) {
        const Quatf rotation = (motion.deltaRotation * pose.rotation).normalized();
        return angularVelocityOf(body, rotation.matrix(), body.angularMomentum);
    }
    TorqueFreeMotion since{{}, pose.rotation.matrix().transposedTimes(motion.angularVelocity)};
    if (lengthSquared(since.angularVelocity) * h * h < kResting * kResting) return since.angularVelocity;
    for (int k = 0; k < count; ++k) since = advanced(body, since, h);
    return since.angularVelocity;
}

}  // namespace

Vec3f angularMomentum(const WorldState& state, std::uint32_t number) {
    const Body& body = state.bodies[number];
    const BodyMotion& motion = state.motions[number];
    if (isUntouched(body, motion)) return body.angularMomentum;
    const Mat3f rotation = state.poses[number].rotation.matrix();
    return rotation * (body.inertia * rotation.transposedTimes(motion.angularVelocity));
}

bool isFastRotating(const WorldState& state, std::uint32_t body, float dt) {
    const float least = state.bodies[body].firstContact == kNone ? kFlyingAngle : kFastAngle;
    return state.bodies[body].isDynamic() &&
           lengthSquared(state.motions[body].angularVelocity) * dt * dt > least * least;
}

void forgetAngularMomentum(WorldState& state, std::uint32_t body) {
    state.bodies[body].referenceAngularVelocity = Vec3f(std::numeric_limits<float>::quiet_NaN());
}

void rotateFreely(WorldState& state, std::uint32_t number, int subStep, float h) {
    Body& body = state.bodies[number];
    BodyMotion& motion = state.motions[number];
    const Quatf start = state.poses[number].rotation;
    const Quatf rotation = (motion.deltaRotation * start).normalized();
    const Vec3f velocity = angularVelocityInBody(state, number, subStep, h);
    if (!isUntouched(body, motion)) {
        body.angularMomentum = rotation.matrix() * (body.inertia * velocity);
        body.referenceAngularVelocity = motion.angularVelocity;
    }
    motion.deltaRotation = advanced(body, {rotation, velocity}, h).rotation * start.conjugate();
}

void applyRotation(WorldState& state, std::uint32_t number, int subSteps, float h) {
    Body& body = state.bodies[number];
    BodyPose& pose = state.poses[number];
    BodyMotion& motion = state.motions[number];
    const Quatf rotation = (motion.deltaRotation * pose.rotation).normalized();
    if (body.isDynamic()) {
        const Mat3f matrix = rotation.matrix();
        const Vec3f velocity = angularVelocityInBody(state, number, subSteps, h);
        if (!isUntouched(body, motion)) body.angularMomentum = matrix * (body.inertia * velocity);
        body.referenceAngularVelocity = motion.angularVelocity = matrix * velocity;
        pose.inverseInertia = rotated(body.inverseInertia, matrix);
    }
    pose.rotation = rotation;
}

}  // namespace rubble
