#include "core/physics/Spin.h"
#include "core/physics/World.h"
#include "core/physics/WorldState.h"

#include <cstring>

namespace rubble {
namespace {

void addBits(Hasher& hasher, float a, float b) {
    std::uint32_t bits[2];
    const float values[2] = {a + 0.0f, b + 0.0f};  // one zero only
    std::memcpy(bits, values, sizeof bits);
    hasher.add(static_cast<std::uint64_t>(bits[0]) << 32 | bits[1]);
}

}  // namespace

ContentHash World::hash() const {
    Hasher hasher;
    for (BodyId body : bodies()) {
        const BodyPlace& place = m_state->places[body.index];
        const BodyMotion& motion = m_state->motions[body.index];
        hasher.add(static_cast<std::uint64_t>(body.index) << 1 | (m_state->bodies[body.index].isAwake ? 1u : 0u));
        addBits(hasher, place.centre.x, place.centre.y);
        addBits(hasher, place.centre.z, place.turn.x);
        addBits(hasher, place.turn.y, place.turn.z);
        addBits(hasher, place.turn.w, motion.velocity.x);
        addBits(hasher, motion.velocity.y, motion.velocity.z);
        addBits(hasher, motion.spin.x, motion.spin.y);
        addBits(hasher, motion.spin.z, 0.0f);
    }
    return hasher.digest();
}

Momenta World::momenta() const {
    Momenta sum;
    for (BodyId id : bodies()) {
        const Body& body = m_state->bodies[id.index];
        if (!body.isDynamic()) continue;
        const BodyPlace& place = m_state->places[id.index];
        const BodyMotion& motion = m_state->motions[id.index];
        const Vec3 spin = toDouble(motion.spin), velocity = toDouble(motion.velocity),
                   centre = toDouble(place.centre) + toDouble(body.centreRest);
        const Vec3 turning = toDouble(angularMomentum(*m_state, id.index));
        const double mass = body.mass;
        sum.linear += mass * velocity;
        sum.angular += turning + mass * glm::cross(centre, velocity);
        sum.kinetic += 0.5 * mass * glm::dot(velocity, velocity) + 0.5 * glm::dot(spin, turning);
        sum.potential -= mass * glm::dot(toDouble(m_state->gravity), centre);
    }
    return sum;
}

}  // namespace rubble
