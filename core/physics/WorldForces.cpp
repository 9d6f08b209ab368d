#include "core/base/Assert.h"
#include "core/physics/Bodies.h"
#include "core/physics/Contacts.h"
#include "core/physics/Sleeping.h"
#include "core/physics/World.h"
#include "core/physics/WorldState.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kNearest = 0.1;  // m: a blast is no stronger nearer than that

void push(WorldState& state, std::uint32_t body, Vec3f impulse, Vec3f arm) {
    BodyMotion& motion = state.motions[body];
    motion.velocity += impulse * motion.inverseMass;
    motion.spin += state.places[body].inverseInertia * cross(arm, impulse);
}

/// Forgets a body's contacts: the next collide() finds them as if it were new.
void meetAgain(WorldState& state, std::uint32_t body) {
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
    giveMaterial(*m_state, body.index, material);
    meetAgain(*m_state, body.index);
}

void World::setVelocity(BodyId body, Vec3 velocity, Vec3 angularVelocity) {
    RUBBLE_ASSERT(contains(body) && kind(body) != BodyKind::Static);
    BodyMotion& motion = m_state->motions[body.index];
    motion.velocity = toFloat(velocity);
    motion.spin = toFloat(angularVelocity);
    wake(body);
    if (kind(body) == BodyKind::Kinematic) wakeNeighbours(*m_state, body.index);
}

void World::setPose(BodyId body, const Pose& pose) {
    RUBBLE_ASSERT(contains(body));
    wake(body);
    wakeNeighbours(*m_state, body.index);
    placeBody(*m_state, body.index, pose);
    meetAgain(*m_state, body.index);
}

void World::wake(BodyId body) {
    RUBBLE_ASSERT(contains(body));
    wakeBody(*m_state, body.index);
}

void World::applyImpulse(BodyId body, Vec3 impulse, Vec3 point) {
    RUBBLE_ASSERT(contains(body));
    wake(body);
    push(*m_state, body.index, toFloat(impulse), toFloat(point) - m_state->places[body.index].centre);
}

std::vector<BlastPush> World::blast(Vec3 point, double radius, double impulse) const {
    std::vector<BlastPush> pushes;
    for (BodyId body : bodies()) {
        const Vec3 centre = toDouble(m_state->places[body.index].centre);
        const Vec3 way = centre - point;
        const double distance = std::sqrt(glm::dot(way, way));
        if (distance > radius || distance == 0.0) continue;
        const double nearest = std::max(distance, kNearest);
        // A convex body turns a quarter of its surface to one side, in the mean over all sides (Cauchy).
        const double facingArea = shape(body).surface / 4.0;
        pushes.push_back({body, centre, way * (impulse * facingArea / (nearest * nearest * distance))});
    }
    return pushes;
}

void World::explode(Vec3 point, double radius, double impulse) {
    for (const BlastPush& push : blast(point, radius, impulse)) {
        if (kind(push.body) == BodyKind::Dynamic) applyImpulse(push.body, push.impulse, push.point);
    }
}

void World::grab(BodyId body, Vec3 point, double force) {
    RUBBLE_ASSERT(contains(body) && kind(body) == BodyKind::Dynamic);
    wake(body);
    const BodyPlace& place = m_state->places[body.index];
    m_state->grabbed = body;
    m_state->grabPlace = place.turn.matrix().transposedTimes(toFloat(point) - place.centre);
    m_state->grabForce = static_cast<float>(force);
    dragTo(point);
}

void World::dragTo(Vec3 point) {
    m_state->grabTarget = toFloat(point);
    if (m_state->grabbed.index != 0) wakeBody(*m_state, m_state->grabbed.index);
}

void World::letGo() { m_state->grabbed = {}; }

}  // namespace rubble
