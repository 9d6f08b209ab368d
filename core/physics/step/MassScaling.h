#pragma once

#include "core/physics/solver/SolverKernels.h"
#include "core/physics/state/WorldState.h"
#include "core/physics/step/LoadPaths.h"

#include <span>
#include <vector>

namespace rubble {

/// A body whose inertia differs from its own for a step.
struct ScaledBody {
    std::uint32_t body = 0;
    float inverseScale = 1.0f;  // its inverse mass in the step, by its own
    float inverseMass = 0.0f;   // 1/kg, its own
    SymMat3f inverseInertia;    // 1/(kg·m²), its own
};

/// Raises the inertia of bodies that carry more than kMaxLoadRatio times their mass (LoadPaths.h) to the load divided
/// by kMaxLoadRatio, for one step, and prepares their contacts again. The heavy body lends them the mass, up to half of
/// its own, so that together they move as before. Call after prepareContacts(), whose list of blocks is `unequal`, and
/// restoreMasses() after solveSubSteps().
///
/// An impulse on a light body changes the motion of the heavy one on it by little: to carry it, the solver would need
/// as many iterations as their masses differ. But a body between a load and the ground hardly moves, and its inertia
/// does not matter. Weights stay (correctGravity()), and so do all forces at rest.
/// Source: Olovsson, Simonsson, Unosson 2005, "Selective mass scaling for explicit finite element analyses".
std::vector<ScaledBody> scaleMasses(WorldState& state, std::span<const BlockList> unequal, const SolverKernels& kernels,
                                    const SolverStep& step);
/// Corrects the acceleration by gravity in a sub-step, after integrateVelocities(), to that of the bodies' own weight.
void correctGravity(WorldState& state, std::span<const ScaledBody> scaled, const SolverStep& step);
void restoreMasses(WorldState& state, std::span<const ScaledBody> scaled);

}  // namespace rubble
