#pragma once

#include "core/physics/math/Lanes.h"
#include "core/physics/solver/BodyMotion.h"
#include "core/physics/solver/ContactBlock.h"

#include <cstddef>
#include <span>

namespace rubble {

/// The coefficients of a soft constraint; SoftContactKernels.h has the equation. The default is a rigid one.
/// Source: Catto 2011, "Soft constraints".
struct Softness {
    float biasRate = 0.0f;      // 1/s: the part of an overlap that is resolved in a second
    float massScale = 1.0f;     // (0, 1]: the part of the speed that is cancelled
    float impulseScale = 0.0f;  // [0, 1): the part of the impulse that is released
};

/// The largest load on a body, as a multiple of its mass, that the sub-steps carry well.
inline constexpr float kMaxLoadRatio = 10.0f;
/// The largest overlap of contacts under the load of high piles, as a multiple of that up to which they are soft.
inline constexpr float kDeepOverlap = 1.6f;

/// The parameters of a step, for all passes.
struct SolverStep {
    BodyMotion* motions = nullptr;    // by body
    const BodyPose* poses = nullptr;  // by body
    float dt = 0.0f;                  // s, of the whole step
    float subStep = 0.0f;             // s
    Vec3f gravity{0.0f, 0.0f, 0.0f};  // m/s²
    Softness betweenBodies;
    Softness againstFixed;          // stiffer, so that bodies are not pushed through the ground
    float pushOutSpeed = 0.0f;      // m/s: the largest bias velocity
    float restitutionSpeed = 0.0f;  // m/s: no restitution below it
};

/// What needs more than the passes of the solver in some blocks.
struct BlockTraits {
    bool isUnequal = false;  // two dynamic bodies differ by more than kMaxLoadRatio in mass
    bool isDeep = false;     // points may overlap by more than kDeepOverlap
};

/// The solver's passes over blocks of contacts that share no dynamic body, or over bodies. All SIMD widths give the
/// same bits.
struct SolverKernels {
    /// One bit per lane: set if its manifold is outdated, since its bodies moved or rotated too far relative to each
    /// other.
    unsigned (*staleLanes)(const ContactBlock& block, const ReferenceBlock& reference, const SolverStep& step);
    /// Computes current separations and effective masses.
    BlockTraits (*prepare)(std::span<ContactBlock> blocks, std::span<const ReferenceBlock> references,
                           const SolverStep& step);
    /// Applies the impulses of the last sub-step.
    void (*warmStart)(std::span<ContactBlock> blocks, const SolverStep& step);
    /// Normal impulses, with a bias velocity that resolves overlaps.
    void (*solve)(std::span<ContactBlock> blocks, const SolverStep& step);
    /// Normal impulses without bias, which removes the bias velocity, and friction.
    void (*relax)(std::span<ContactBlock> blocks, const SolverStep& step);
    /// Restitution of points that approached faster than the restitution speed.
    void (*restitute)(std::span<ContactBlock> blocks, const SolverStep& step);
    void (*integrateVelocities)(std::span<const std::uint32_t> bodies, const SolverStep& step);
    void (*integratePositions)(std::span<const std::uint32_t> bodies, const SolverStep& step);
    /// The energies that bodies lost in the sub-steps, while the poses are still those before them; 0 of what is not
    /// dynamic. `starts` and `losses` are by body.
    void (*findLosses)(std::span<const std::uint32_t> bodies, const SolverStep& step, const StartMotion* starts,
                       BodyLoss* losses);
};

/// The kernels of a SIMD width that this machine supports.
const SolverKernels& kernelsOf(SimdWidth width);

}  // namespace rubble
