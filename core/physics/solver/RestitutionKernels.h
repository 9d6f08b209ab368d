#pragma once

#include "core/physics/solver/ImpactKernels.h"

// Newton's law of restitution. A point that approached at the speed v0 < 0 before the step, faster than the restitution
// speed, and was hit in it shall separate at -e v0, with e the restitution of the pair: with v the normal speed after
// the sub-steps, impulses cancel the residual
//     v + e v0.
// Source: Catto 2024, "Solver2D" (restitution as a pass of its own, after all sub-steps).

namespace rubble {

/// The pass after the sub-steps: restitution.
template <int W>
struct RestitutionKernels : ContactLanes<W> {
    using Lanes = ContactLanes<W>;
    using F = typename Lanes::F;
    using V = typename Lanes::V;
    using Lanes::apply;
    using Lanes::maxPointCount;
    using Lanes::normalSpeed;
    using Lanes::put;
    using Lanes::putVelocities;
    using Lanes::row;
    using Lanes::velocities;
    using typename Lanes::Velocities;

    static constexpr int kIterations = 8;  // per point; after one, a box that lands flat would rotate

    static void restitute(std::span<ContactBlock> blocks, const SolverStep& step) {
        for (ContactBlock& block : blocks) {
            for (int part = 0; part < kBlockLanes / W; ++part) {
                const F restitution = row(block.restitution, part);
                const int points = maxPointCount(block, part);
                if (points == 0 || bitsOf<W>(restitution > F{}) == 0) continue;
                Velocities a = velocities(block.first, part, step), b = velocities(block.second, part, step);
                restoreTogether(block, part, points, restitution, step, a, b);
                restoreOneByOne(block, part, points, restitution, step, a, b);
                putVelocities(a, block.first, part, step);
                putVelocities(b, block.second, part, step);
            }
        }
    }

private:
    /// Points that only came near were not hit.
    [[gnu::always_inline]] static Masks<W> isHit(const PointRows& point, int part, F restitution,
                                                 const SolverStep& step) {
        return (row(point.approach, part) < all<W>(-step.restitutionSpeed)) & (row(point.stepImpulse, part) > F{}) &
               (restitution > F{});
    }

    /// Restores the speeds of all points that were hit together, where none of them would have to pull.
    [[gnu::always_inline]] static void restoreTogether(ContactBlock& block, int part, int points, F restitution,
                                                       const SolverStep& step, Velocities& a, Velocities& b) {
        const V n = row(block.normal, part), centreOffset = row(block.centreOffset, part);
        F residuals[4]{}, speeds[4]{}, impulses[4]{};
        const auto speed = normalSpeed(n, centreOffset, a, b);
        for (int i = 0; i < points; ++i) {
            const PointRows& point = block.points[i];
            impulses[i] = row(point.impulse, part);
            speeds[i] = speed.at(row(point.position, part));
            residuals[i] = select<W>(isHit(point, part, restitution, step),
                                     speeds[i] + restitution * row(point.approach, part), F{});  // v + e v0
        }
        const auto isImpact = ImpactKernels<W>::impacts(residuals);
        apply(ImpactKernels<W>::solve(block, part, points, isImpact, residuals, speeds), n, centreOffset, block, part,
              a, b);
        for (int i = 0; i < points; ++i) {
            PointRows& point = block.points[i];
            put(row(point.stepImpulse, part) + (row(point.impulse, part) - impulses[i]), point.stepImpulse, part);
        }
    }

    /// Restores the speeds of the points one after the other, several times.
    [[gnu::always_inline]] static void restoreOneByOne(ContactBlock& block, int part, int points, F restitution,
                                                       const SolverStep& step, Velocities& a, Velocities& b) {
        const V n = row(block.normal, part), centreOffset = row(block.centreOffset, part);
        for (int round = 0; round < kIterations * points; ++round) {
            PointRows& point = block.points[round % points];
            const V position = row(point.position, part);
            const F speed = normalSpeed(n, centreOffset, a, b).at(position);     // v
            const F residual = speed + restitution * row(point.approach, part);  // v + e v0
            const F before = row(point.impulse, part);
            F after = greater<W>(before - row(point.effectiveMass, part) * residual, F{});
            after = select<W>(isHit(point, part, restitution, step), after, before);
            const F change = after - before;
            put(after, point.impulse, part);
            put(row(point.stepImpulse, part) + change, point.stepImpulse, part);
            apply({change, position * change}, n, centreOffset, block, part, a, b);
        }
    }
};

}  // namespace rubble
