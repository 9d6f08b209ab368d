#pragma once

#include "core/physics/world/World.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// What changed the energy of bodies in a step, outside of the solver.
enum class EnergyChange : std::uint8_t {
    Throw,         // a source: a projectile was created
    Blow,          // a source: the work of a hammer
    Blast,         // a source: the work of a blast
    BreakImpulse,  // between a body that breaks and its impactor
    Swap,          // of a body for its fragments
    Cut,           // of a body for fragments cut at the point of impact
    Bonds,         // between a body whose bonds break and its impactor
    Split,         // of a body into the islands of its bonds
};

/// The mechanical energy of the bodies that something changed, before and after, J. Computed in double precision, in
/// the order of the bodies.
struct EnergyEntry {
    EnergyChange change = EnergyChange::Swap;
    std::uint32_t body = 0;  // number of the thrown, struck or broken body; 0 for a blast
    double before = 0.0;
    double given = 0.0;     // by the source
    double after = 0.0;     // kinetic energy, and the potential energy gained since before
    double rounding = 0.0;  // of potential energy, by the positions of the new bodies

    /// Whether only the source added energy, within 1 % and rounding: the world has velocities in single precision, but
    /// a rigid motion that a break changes gains at most some 1e-6 by that.
    bool isConserved() const;
};
using EnergyAudit = std::vector<EnergyEntry>;

/// The positions of bodies are rounded to less than kPositionRounding, m, within kRoundedDistance, m, of the origin
/// (see World); farther out in proportion.
inline constexpr double kPositionRounding = 1e-5, kRoundedDistance = 100.0;

/// The kinetic energy of a rigid body, J; `inertia`, kg·m², about its centre, in world axes.
double kineticEnergy(double mass, const Mat3& inertia, Vec3 velocity, Vec3 angularVelocity);
/// The same of a body of the world; 0 unless it is dynamic.
double kineticEnergy(const World& world, BodyId body);
/// The sum over all dynamic bodies, J.
double kineticEnergy(const World& world);

}  // namespace rubble
