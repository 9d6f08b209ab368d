#include "core/base/Assert.h"
#include "core/base/MessageText.h"
#include "core/physics/islands/Sleeping.h"
#include "core/physics/state/Contacts.h"
#include "core/physics/state/VerifyBody.h"
#include "core/physics/state/WorldState.h"
#include "core/physics/world/Bodies.h"
#include "core/physics/world/World.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

Error rangeError(const std::string& what, double most, const char* unit) {
    return {ErrorCode::BadInput, what + " must be finite and at most " + messageText(most) + " " + unit + "."};
}

/// The vector, shortened to a length.
Vec3 limited(Vec3 v, double most) {
    const double length = glm::length(v);
    return length > most ? v * (most / length) : v;
}

/// Applies an impulse that may be too strong for single precision.
void applyStrongImpulse(WorldState& state, std::uint32_t body, Vec3 impulse, Vec3 arm) {
    BodyMotion& motion = state.motions[body];
    const SymMat3f& inverse = state.poses[body].inverseInertia;
    const Vec3 torque = glm::cross(arm, impulse);
    const Vec3 turned(inverse.xx * torque.x + inverse.xy * torque.y + inverse.xz * torque.z,
                      inverse.xy * torque.x + inverse.yy * torque.y + inverse.yz * torque.z,
                      inverse.xz * torque.x + inverse.yz * torque.y + inverse.zz * torque.z);
    motion.velocity =
        toFloat(limited(toDouble(motion.velocity) + impulse * static_cast<double>(motion.inverseMass), kMaxSpeed));
    motion.angularVelocity = toFloat(limited(toDouble(motion.angularVelocity) + turned, kMaxSpeed));
}

/// What the body may reach in the coming step has changed: collide() considers it again, also where the step has been
/// collided already.
void applyImpulseAt(WorldState& state, std::uint32_t body, Vec3 impulse, Vec3 point) {
    invalidateGaps(state, body);
    state.rebox.push_back(body);
    const Vec3f arm = toFloat(point) - state.poses[body].centre;
    const BodyMotion& motion = state.motions[body];
    if (isWithin(impulse, kMaxImpulse)) {
        BodyMotion moved = motion;
        const Vec3f push = toFloat(impulse);
        moved.velocity += push * motion.inverseMass;
        moved.angularVelocity += state.poses[body].inverseInertia * cross(arm, push);
        if (isWithin(toDouble(moved.velocity), kMaxSpeed) && isWithin(toDouble(moved.angularVelocity), kMaxSpeed)) {
            state.motions[body] = moved;
            return;
        }
    }
    applyStrongImpulse(state, body, impulse, toDouble(arm));
}

/// Removes a body's contacts, so that the next collide() finds them again.
void resetContacts(WorldState& state, std::uint32_t body) {
    visitContacts(state, body, [&](std::uint32_t contact, std::uint32_t) { removeContact(state, contact); });
    state.rebox.push_back(body);
}

/// Has no contact warm start: its impulses carried another weight.
void forgetImpulses(WorldState& state) {
    for (ContactColours::List& list : state.colours.lists()) {
        for (ContactBlock& block : list.blocks) {
            for (PointRows& point : block.points) point.impulse = {};
            block.frictionX = block.frictionY = block.torsionalImpulse = {};
        }
    }
}

}  // namespace

Vec3 World::gravity() const { return toDouble(m_state->gravity); }

Status World::setGravity(Vec3 gravity) {
    if (!isWithin(gravity, kMaxSpeed)) return rangeError("Gravity", kMaxSpeed, "m/s² along each axis");
    m_state->gravity = toFloat(gravity);
    for (BodyId body : bodies()) wakeBody(*m_state, body.index);
    forgetImpulses(*m_state);
    return success();
}

Status World::setMaterial(BodyId body, const BodyMaterial& material) {
    RUBBLE_ASSERT(contains(body));
    if (const auto fault = verifyMaterial(material, shape(body), kind(body))) {
        return Error{ErrorCode::BadInput, *fault};
    }
    wake(body);
    wakeNeighbours(*m_state, body.index);
    rubble::setMaterial(*m_state, body.index, material);
    resetContacts(*m_state, body.index);
    return success();
}

Status World::setVelocity(BodyId body, Vec3 velocity, Vec3 angularVelocity) {
    RUBBLE_ASSERT(contains(body) && kind(body) != BodyKind::Static);
    if (!isWithin(velocity, kMaxSpeed) || !isWithin(angularVelocity, kMaxSpeed)) {
        return rangeError("A velocity", kMaxSpeed, "m/s or rad/s along each axis");
    }
    BodyMotion& motion = m_state->motions[body.index];
    const Vec3f linear = toFloat(velocity), angular = toFloat(angularVelocity);
    const bool isChanged = motion.velocity != linear || motion.angularVelocity != angular;
    motion.velocity = linear;
    motion.angularVelocity = angular;
    wake(body);
    if (kind(body) == BodyKind::Kinematic && isChanged) wakeNeighbours(*m_state, body.index);
    return success();
}

Status World::setPose(BodyId body, const Pose& pose) {
    RUBBLE_ASSERT(contains(body));
    if (const auto fault = verifyPose(pose, "a body")) return Error{ErrorCode::BadInput, *fault};
    wake(body);
    wakeNeighbours(*m_state, body.index);
    rubble::setPose(*m_state, body.index, pose);
    resetContacts(*m_state, body.index);
    return success();
}

void World::wake(BodyId body) {
    RUBBLE_ASSERT(contains(body));
    wakeBody(*m_state, body.index);
}

Status World::applyImpulse(BodyId body, Vec3 impulse, Vec3 point) {
    RUBBLE_ASSERT(contains(body));
    if (const auto fault = verifyImpulse(impulse, point)) return Error{ErrorCode::BadInput, *fault};
    wake(body);
    applyImpulseAt(*m_state, body.index, impulse, point);
    return success();
}

Status World::explode(Vec3 point, double radius, double impulse) {
    if (!isWithin(point, kMaxCoordinate) || !(radius >= 0.0 && radius <= kMaxCoordinate)) {
        return rangeError("The place and radius of a blast", kMaxCoordinate, "m");
    }
    if (!isWithin(Vec3(impulse), kMaxImpulse)) {
        return rangeError("The impulse of a blast", kMaxImpulse, "N·s/m²");
    }
    for (const BlastImpulse& one : blast(blastOrigin(point), radius, impulse)) {
        if (kind(one.body) != BodyKind::Dynamic) continue;
        wake(one.body);
        applyImpulseAt(*m_state, one.body.index, one.impulse, one.point);
    }
    return success();
}

Status World::grab(BodyId body, Vec3 point, double force) {
    RUBBLE_ASSERT(contains(body) && kind(body) == BodyKind::Dynamic);
    if (!isWithin(point, kMaxCoordinate)) return rangeError("A place", kMaxCoordinate, "m along each axis");
    if (!(force >= 0.0 && force <= kMaxImpulse)) return rangeError("The force of a grab", kMaxImpulse, "N");
    wake(body);
    const BodyPose& pose = m_state->poses[body.index];
    m_state->grabbed = body;
    m_state->grabPoint = pose.rotation.matrix().transposedTimes(toFloat(point) - pose.centre);
    m_state->grabForce = static_cast<float>(force);
    return dragTo(point);
}

Status World::dragTo(Vec3 point) {
    if (!isWithin(point, kMaxCoordinate)) return rangeError("A place", kMaxCoordinate, "m along each axis");
    m_state->grabTarget = toFloat(point);
    if (m_state->grabbed.index != 0) wakeBody(*m_state, m_state->grabbed.index);
    return success();
}

void World::release() { m_state->grabbed = {}; }

std::optional<GrabSpring> World::grabSpring() const {
    const WorldState& state = *m_state;
    if (state.grabbed.index == 0) return std::nullopt;
    const BodyPose& pose = state.poses[state.grabbed.index];
    return GrabSpring{.body = state.grabbed,
                      .point = toDouble(pose.centre + pose.rotation.matrix() * state.grabPoint),
                      .target = toDouble(state.grabTarget),
                      .force = state.grabForce};
}

}  // namespace rubble
