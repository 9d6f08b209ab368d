#pragma once

#include "core/physics/solver/ContactLanes.h"

namespace rubble {

/// Solves the points of manifolds that collide within a sub-step together. One after the other, the first point would
/// stop the body alone and make it rotate; at rest, warm starting corrects that from step to step, but an impact lasts
/// no longer than one.
template <int W>
struct ImpactKernels : ContactLanes<W> {
    using Lanes = ContactLanes<W>;
    using F = typename Lanes::F;
    using Lanes::put;
    using Lanes::row;
    using typename Lanes::NormalImpulse;

    // Slower ones are left to the other passes. Gravity adds less in a sub-step, so bodies at rest are not concerned.
    static constexpr float kMinSpeed = 0.1f;  // m/s

    /// The speeds along the normal that impulses have to cancel, m/s; 0 at points that do not push.
    using Residuals = F[4];

    /// The manifolds with a point that collides.
    [[gnu::always_inline]] static Masks<W> impacts(const Residuals& residuals) {
        Masks<W> isImpact{};
        for (const F& residual : residuals) {
            isImpact |= residual * residual > all<W>(kMinSpeed * kMinSpeed);
        }
        return isImpact;
    }

    /// Cancels the residuals of the manifolds of a mask and updates the speeds of their points. Manifolds that would
    /// have to pull at a point are left as they are. Returns the changes of the impulses.
    static NormalImpulse solve(ContactBlock& block, int part, int points, Masks<W> isImpact, const Residuals& residuals,
                               F* speeds) {
        constexpr float kMaxPull = 1e-4f;  // relative to the largest impulse: less is rounding
        const PointMatrix matrix(block, part, points);
        F changes[4]{}, least{}, most{};
        conjugateGradients(matrix, points, isImpact, residuals, changes);
        for (int i = 0; i < points; ++i) {
            const F after = row(block.points[i].impulse, part) + changes[i];
            least = lesser<W>(least, after);
            most = greater<W>(most, after);
        }
        const Masks<W> isSolved = isImpact & (least >= -kMaxPull * most);
        NormalImpulse impulses;
        for (int i = 0; i < points; ++i) {
            PointRows& point = block.points[i];
            const F before = row(point.impulse, part);
            const F after = select<W>(isSolved, greater<W>(before + changes[i], F{}), before);
            changes[i] = after - before;
            put(after, point.impulse, part);
            impulses.sum = impulses.sum + changes[i];
            impulses.moment = impulses.moment + row(point.position, part) * changes[i];
        }
        for (int i = 0; i < points; ++i) speeds[i] = speeds[i] + matrix.times(changes, i);
        return impulses;
    }

private:
    /// The changes of the speeds at all points by unit impulses at each, 1/kg.
    struct PointMatrix {
        PointMatrix(const ContactBlock& block, int part, int points) : count(points) {
            for (int i = 0; i < points; ++i) {
                rows[i][i] = inverseOrZero<W>(row(block.points[i].effectiveMass, part));
                stiffest = greater<W>(stiffest, rows[i][i]);
                for (int j = i + 1; j < points; ++j) {
                    rows[i][j] = rows[j][i] = row(block.coupling[couplingIndex(i, j)], part);
                }
            }
        }
        F times(const F* impulses, int i) const {
            F sum{};
            for (int j = 0; j < count; ++j) sum = sum + rows[i][j] * impulses[j];
            return sum;
        }
        int count;
        F rows[4][4]{};
        F stiffest{};  // the largest on the diagonal
    };

    /// The least-squares impulses that cancel the residuals. The speeds of a manifold's points have three degrees of
    /// freedom, so three iterations are exact.
    /// Source: Hestenes, Stiefel 1952, "Methods of conjugate gradients for solving linear systems".
    static void conjugateGradients(const PointMatrix& matrix, int points, Masks<W> isImpact, const Residuals& residuals,
                                   F* impulses) {
        constexpr int kIterations = 3;
        constexpr float kMinCurvature = 1e-4f;  // relative to the stiffest point: less is rounding
        constexpr float kMinSquared = 1e-11f;   // relative to the residuals: less is rounding
        F remainder[4]{}, direction[4]{}, squared{};
        for (int i = 0; i < points; ++i) {
            remainder[i] = direction[i] = select<W>(isImpact, -residuals[i], F{});
            squared = squared + remainder[i] * remainder[i];
        }
        const F rounding = kMinSquared * squared;
        for (int k = 0; k < kIterations; ++k) {
            F response[4]{}, length{}, curvature{}, left{};
            for (int i = 0; i < points; ++i) {
                response[i] = select<W>(residuals[i] == F{}, F{}, matrix.times(direction, i));
                length = length + direction[i] * direction[i];
                curvature = curvature + direction[i] * response[i];
            }
            const auto isCurved = curvature > kMinCurvature * matrix.stiffest * length;
            const F step = select<W>(isCurved, squared * inverseOrZero<W>(curvature), F{});
            for (int i = 0; i < points; ++i) {
                impulses[i] = impulses[i] + step * direction[i];
                remainder[i] = remainder[i] - step * response[i];
                left = left + remainder[i] * remainder[i];
            }
            const auto isLeft = left > rounding;
            const F ratio = select<W>(isLeft, left * inverseOrZero<W>(squared), F{});
            for (int i = 0; i < points; ++i) {
                direction[i] = select<W>(isLeft, remainder[i] + ratio * direction[i], F{});
            }
            squared = left;
        }
    }
};

}  // namespace rubble
