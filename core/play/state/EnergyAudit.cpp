#include "core/play/state/EnergyAudit.h"

#include <cmath>

namespace rubble {

bool EnergyEntry::isConserved() const {
    constexpr double kRelative = 0.01;
    constexpr double kAbsolute = 1e-9;  // J: of motions that single precision rounds to zero
    const double most = before + given;
    return after <= most + kRelative * (before + std::abs(given)) + rounding + kAbsolute;
}

double kineticEnergy(double mass, const Mat3& inertia, Vec3 velocity, Vec3 angularVelocity) {
    return 0.5 * mass * glm::dot(velocity, velocity) + 0.5 * glm::dot(angularVelocity, inertia * angularVelocity);
}

double kineticEnergy(const World& world, BodyId body) {
    if (world.kind(body) != BodyKind::Dynamic) return 0.0;
    const BodyState state = world.state(body);
    const Shape& shape = world.shape(body);
    const double mass = world.mass(body);
    const Vec3 turning = glm::conjugate(state.pose.orientation) * state.angularVelocity;  // in the body's axes
    return kineticEnergy(mass, (mass / shape.mass.volume) * shape.inertia, state.velocity, turning);
}

double kineticEnergy(const World& world) {
    double sum = 0.0;
    for (const BodyId body : world.bodies()) sum += kineticEnergy(world, body);
    return sum;
}

}  // namespace rubble
