#pragma once

#include "core/physics/BodyRows.h"
#include "core/physics/ContactBlock.h"
#include "core/physics/Lanes.h"

#include <cstddef>
#include <span>

namespace rubble {

/// A spring and damper as the soft step takes them.
/// Source: Catto 2011, "Soft constraints".
struct Softness {
    float biasRate = 0.0f;  // 1/s
    float massScale = 1.0f;
    float impulseScale = 0.0f;
};

/// What every pass of the solver reads.
struct SolverStep {
    BodyMotion* motions = nullptr;      // by body
    const BodyPlace* places = nullptr;  // by body
    float dt = 0.0f;                    // s, of the whole step
    float subStep = 0.0f;               // s
    Vec3f gravity{0.0f, 0.0f, 0.0f};    // m/s^2
    Softness betweenBodies;
    Softness againstFixed;          // stiffer, so that nothing is pushed through the ground
    float pushOutSpeed = 0.0f;      // m/s
    float restitutionSpeed = 0.0f;  // m/s: nothing is thrown back below it
};

/// The solver's passes, over blocks of contacts that share no dynamic body, or over bodies. Those of all widths give the same bits.
struct SolverKernels {
    /// A bit for each lane whose manifold must be made anew, since its bodies moved too far against each other, or turned.
    unsigned (*staleLanes)(const ContactBlock& block, const ReferenceBlock& reference, const SolverStep& step);
    /// Fills in what the passes need: where the points are now, and how bodies answer to impulses there.
    void (*prepare)(std::span<ContactBlock> blocks, std::span<const ReferenceBlock> references, const SolverStep& step);
    /// Applies the impulses of the last sub-step again.
    void (*warmStart)(std::span<ContactBlock> blocks, const SolverStep& step);
    /// Impulses against approach, with a bias that pushes overlaps apart.
    void (*solve)(std::span<ContactBlock> blocks, const SolverStep& step);
    /// Impulses against approach and slip, without the bias: takes out the speed that it gave.
    void (*relax)(std::span<ContactBlock> blocks, const SolverStep& step);
    /// Throws back what came in faster than the restitution speed.
    void (*restitute)(std::span<ContactBlock> blocks, const SolverStep& step);
    void (*integrateVelocities)(std::span<const std::uint32_t> bodies, const SolverStep& step);
    void (*integratePositions)(std::span<const std::uint32_t> bodies, const SolverStep& step);
};

/// The kernels for a width that this machine runs.
const SolverKernels& kernelsOf(LaneWidth width);

}  // namespace rubble
