#include "core/play/breaking/MovingMass.h"

#include "core/play/state/EnergyAudit.h"

#include <algorithm>

namespace rubble {

double MovingMass::inverseEffectiveMass(Vec3 point, Vec3 direction) const {
    const Vec3 arm = glm::cross(point - centre, direction);
    return inverseMass + glm::dot(arm, inverseInertia * arm);
}

void MovingMass::applyImpulse(Vec3 impulse, Vec3 point) {
    velocity += inverseMass * impulse;
    angularVelocity += inverseInertia * glm::cross(point - centre, impulse);
}

double MovingMass::kineticEnergy() const {
    return inverseMass > 0.0 ? rubble::kineticEnergy(1.0 / inverseMass, inertia, velocity, angularVelocity) : 0.0;
}

MovingMass restingMass(const Shape& shape, double density, const Pose& pose) {
    const Mat3 rotation = glm::mat3_cast(pose.orientation);
    MovingMass mass;
    mass.inverseMass = 1.0 / (density * shape.mass.volume);
    mass.inertia = rotation * (density * shape.inertia) * glm::transpose(rotation);
    mass.inverseInertia = glm::inverse(mass.inertia);
    mass.centre = pose.position + rotation * shape.mass.centre;
    return mass;
}

MovingMass movingMass(const World& world, BodyId body) {
    const BodyState state = world.state(body);
    MovingMass mass;
    if (world.kind(body) == BodyKind::Dynamic) {
        const Shape& shape = world.shape(body);
        mass = restingMass(shape, world.mass(body) / shape.mass.volume, state.pose);
    }
    mass.centre = state.centre;
    mass.velocity = state.velocity;
    mass.angularVelocity = state.angularVelocity;
    return mass;
}

double stoppingImpulse(const MovingMass& first, const MovingMass& second, Vec3 point, Vec3 normal, double restitution) {
    const double approach = glm::dot(first.velocityAt(point) - second.velocityAt(point), normal);
    const double inverse = first.inverseEffectiveMass(point, normal) + second.inverseEffectiveMass(point, normal);
    return approach > 0.0 && inverse > 0.0 ? (1.0 + restitution) * approach / inverse : 0.0;
}

Vec3 limitedVelocity(Vec3 velocity) {
    const double speed = glm::length(velocity);
    return speed > kMaxSpeed ? velocity * (kMaxSpeed / speed) : velocity;
}

}  // namespace rubble
