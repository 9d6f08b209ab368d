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

constexpr double kPi = 3.14159265358979323846;
constexpr double kNearest = 0.1;  // m: a blast is no stronger nearer than that

void push(WorldState& state, std::uint32_t body, Vec3f impulse, Vec3f arm) {
    BodyMotion& motion = state.motions[body];
    motion.velocity += impulse * motion.inverseMass;
    motion.spin += state.places[body].inverseInertia * cross(arm, impulse);
}

/// The mean area that a body turns to one side, m^2: a quarter of its surface, taken as a ball's of its volume.
double facingArea(const Shape& shape) {
    const double radius = std::cbrt(3.0 * shape.mass.volume / (4.0 * kPi));
    return kPi * radius * radius;
}

}  // namespace

void World::setGravity(Vec3 gravity) {
    m_state->gravity = toFloat(gravity);
    for (BodyId body : bodies()) wakeBody(*m_state, body.index);
}

void World::setFriction(BodyId body, double friction) {
    RUBBLE_ASSERT(contains(body) && friction >= 0.0);
    m_state->bodies[body.index].friction = static_cast<float>(friction);
    wake(body);
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
    visitContacts(*m_state, body.index,
                  [&](std::uint32_t contact, std::uint32_t) { removeContact(*m_state, contact); });
    m_state->rebox.push_back(body.index);
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

void World::explode(Vec3 point, double radius, double impulse) {
    for (BodyId body : bodies()) {
        if (kind(body) != BodyKind::Dynamic) continue;
        const Vec3 way = toDouble(m_state->places[body.index].centre) - point;
        const double distance = std::sqrt(glm::dot(way, way));
        if (distance > radius || distance == 0.0) continue;
        const double nearest = std::max(distance, kNearest);
        const Vec3 pushed = way * (impulse * facingArea(shape(body)) / (nearest * nearest * distance));
        applyImpulse(body, pushed, toDouble(m_state->places[body.index].centre));
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
