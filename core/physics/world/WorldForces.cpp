#include "core/base/Assert.h"
#include "core/physics/islands/Sleeping.h"
#include "core/physics/state/Contacts.h"
#include "core/physics/state/WorldState.h"
#include "core/physics/world/Bodies.h"
#include "core/physics/world/World.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kMinBlastDistance = 0.1;  // m: a blast is no stronger within

void applyImpulseAt(WorldState& state, std::uint32_t body, Vec3f impulse, Vec3f arm) {
    BodyMotion& motion = state.motions[body];
    motion.velocity += impulse * motion.inverseMass;
    motion.angularVelocity += state.poses[body].inverseInertia * cross(arm, impulse);
}

/// Removes a body's contacts, so that the next collide() finds them again.
void resetContacts(WorldState& state, std::uint32_t body) {
    visitContacts(state, body, [&](std::uint32_t contact, std::uint32_t) { removeContact(state, contact); });
    state.rebox.push_back(body);
}

}  // namespace

Vec3 World::gravity() const { return toDouble(m_state->gravity); }

void World::setGravity(Vec3 gravity) {
    m_state->gravity = toFloat(gravity);
    for (BodyId body : bodies()) wakeBody(*m_state, body.index);
}

void World::setMaterial(BodyId body, const BodyMaterial& material) {
    RUBBLE_ASSERT(contains(body) && material.density > 0.0 && material.friction >= 0.0);
    wake(body);
    wakeNeighbours(*m_state, body.index);
    rubble::setMaterial(*m_state, body.index, material);
    resetContacts(*m_state, body.index);
}

void World::setVelocity(BodyId body, Vec3 velocity, Vec3 angularVelocity) {
    RUBBLE_ASSERT(contains(body) && kind(body) != BodyKind::Static);
    BodyMotion& motion = m_state->motions[body.index];
    motion.velocity = toFloat(velocity);
    motion.angularVelocity = toFloat(angularVelocity);
    wake(body);
    if (kind(body) == BodyKind::Kinematic) wakeNeighbours(*m_state, body.index);
}

void World::setPose(BodyId body, const Pose& pose) {
    RUBBLE_ASSERT(contains(body));
    wake(body);
    wakeNeighbours(*m_state, body.index);
    rubble::setPose(*m_state, body.index, pose);
    resetContacts(*m_state, body.index);
}

void World::wake(BodyId body) {
    RUBBLE_ASSERT(contains(body));
    wakeBody(*m_state, body.index);
}

void World::applyImpulse(BodyId body, Vec3 impulse, Vec3 point) {
    RUBBLE_ASSERT(contains(body));
    wake(body);
    applyImpulseAt(*m_state, body.index, toFloat(impulse), toFloat(point) - m_state->poses[body.index].centre);
}

std::vector<BlastImpulse> World::blast(Vec3 point, double radius, double impulse) const {
    std::vector<BlastImpulse> impulses;
    for (BodyId body : bodies()) {
        const Vec3 centre = toDouble(m_state->poses[body.index].centre);
        const Vec3 displacement = centre - point;
        const double distance = std::sqrt(glm::dot(displacement, displacement));
        if (distance > radius || distance == 0.0) continue;
        const double nearest = std::max(distance, kMinBlastDistance);
        // The mean projected area of a convex body is a quarter of its surface area (Cauchy).
        const double projectedArea = shape(body).surfaceArea / 4.0;
        impulses.push_back({body, centre, displacement * (impulse * projectedArea / (nearest * nearest * distance))});
    }
    return impulses;
}

void World::explode(Vec3 point, double radius, double impulse) {
    for (const BlastImpulse& one : blast(point, radius, impulse)) {
        if (kind(one.body) == BodyKind::Dynamic) applyImpulse(one.body, one.impulse, one.point);
    }
}

void World::grab(BodyId body, Vec3 point, double force) {
    RUBBLE_ASSERT(contains(body) && kind(body) == BodyKind::Dynamic);
    wake(body);
    const BodyPose& pose = m_state->poses[body.index];
    m_state->grabbed = body;
    m_state->grabPoint = pose.rotation.matrix().transposedTimes(toFloat(point) - pose.centre);
    m_state->grabForce = static_cast<float>(force);
    dragTo(point);
}

void World::dragTo(Vec3 point) {
    m_state->grabTarget = toFloat(point);
    if (m_state->grabbed.index != 0) wakeBody(*m_state, m_state->grabbed.index);
}

void World::release() { m_state->grabbed = {}; }

}  // namespace rubble
