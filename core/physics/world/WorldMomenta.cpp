#include "core/physics/state/AngularMomentum.h"
#include "core/physics/state/WorldState.h"
#include "core/physics/world/World.h"

namespace rubble {

Momenta World::momenta() const {
    Momenta sum;
    for (BodyId id : bodies()) {
        const Body& body = m_state->bodies[id.index];
        if (!body.isDynamic()) continue;
        const BodyPose& pose = m_state->poses[id.index];
        const BodyMotion& motion = m_state->motions[id.index];
        const Vec3 angularVelocity = toDouble(motion.angularVelocity), velocity = toDouble(motion.velocity),
                   centre = toDouble(pose.centre) + toDouble(body.centreRemainder);
        const Vec3 ownMomentum = toDouble(angularMomentum(*m_state, id.index));
        const double mass = body.mass;
        sum.linear += mass * velocity;
        sum.angular += ownMomentum + mass * glm::cross(centre, velocity);
        sum.kinetic += 0.5 * mass * glm::dot(velocity, velocity) + 0.5 * glm::dot(angularVelocity, ownMomentum);
        sum.potential -= mass * glm::dot(toDouble(m_state->gravity), centre);
    }
    return sum;
}

}  // namespace rubble
