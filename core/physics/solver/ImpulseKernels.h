#pragma once

#include "core/physics/solver/ImpactKernels.h"

namespace rubble {

/// The passes that apply impulses: warm start, solve, relax and restitution. The derivation is in PrepareKernels.h.
template <int W>
struct ImpulseKernels : ContactLanes<W> {
    using Lanes = ContactLanes<W>;
    using F = typename Lanes::F;
    using V = typename Lanes::V;
    using Q = typename Lanes::Q;
    using Lanes::apply;
    using Lanes::applyAt;
    using Lanes::applyTwist;
    using Lanes::maxPointCount;
    using Lanes::motions;
    using Lanes::put;
    using Lanes::putVelocities;
    using Lanes::row;
    using Lanes::velocities;
    using typename Lanes::Motions;
    using typename Lanes::NormalImpulse;
    using typename Lanes::Velocities;

    // m: separations below it are rounding. In a step of 1/1000 s, impacts as far ahead are measured.
    static constexpr float kTouching = 2e-5f;
    static constexpr int kRestitutionIterations = 8;  // per point; after one, a box that lands flat would rotate

    static void warmStart(std::span<ContactBlock> blocks, const SolverStep& step) {
        for (ContactBlock& block : blocks) {
            for (int part = 0; part < kBlockLanes / W; ++part) {
                const int points = maxPointCount(block, part);
                if (points == 0) continue;
                Velocities a = velocities(block.first, part, step), b = velocities(block.second, part, step);
                const V n = row(block.normal, part), centreOffset = row(block.centreOffset, part),
                        t = row(block.tangent, part);
                NormalImpulse impulses;
                for (int i = 0; i < points; ++i) {
                    const F impulse = row(block.points[i].impulse, part);
                    impulses.sum = impulses.sum + impulse;
                    impulses.moment = impulses.moment + row(block.points[i].position, part) * impulse;
                }
                apply(impulses, n, centreOffset, block, part, a, b);
                const V friction = t * row(block.frictionX, part) + cross<W>(n, t) * row(block.frictionY, part);
                applyAt(friction, row(block.frictionCentre, part), centreOffset, block, part, a, b);
                applyTwist(row(block.twist, part), n, block, part, a, b);
                putVelocities(a, block.first, part, step);
                putVelocities(b, block.second, part, step);
            }
        }
    }

    /// The normal impulses that limit friction.
    struct Load {
        F sum{};       // N·s
        F leverage{};  // N·m·s: sum of impulse times lever, which limits twist at a friction of 1
    };

    /// A point without contact and impulse is left to the next sub-step: slowing it down now would reduce the impact
    /// measured by the next step.
    [[gnu::always_inline]] static Masks<W> isIdle(F separation, F impulse) {
        return (separation > all<W>(kTouching)) & (impulse <= F{});
    }

    template <bool kWithBias>
    [[gnu::always_inline]] static Load applyNormalImpulses(ContactBlock& block, int part, int points,
                                                           const SolverStep& step, const Motions& from, Velocities& a,
                                                           const Motions& to, Velocities& b) {
        const V n = row(block.normal, part), centreOffset = row(block.centreOffset, part);
        const V nA = rotated<W>(from.deltaRotation.conjugate(), n) - n,
                nB = rotated<W>(to.deltaRotation.conjugate(), n) - n;
        const F separationChange = dot<W>(n, to.deltaPosition - from.deltaPosition) + dot<W>(centreOffset, nB);
        const V separationSlope = nB - nA;
        const V spinA = cross<W>(n, a.angularVelocity), spinB = cross<W>(n, b.angularVelocity),
                speedSlope = spinB - spinA;
        const F speed = dot<W>(n, b.linear - a.linear) + dot<W>(centreOffset, spinB);

        F biasRate{}, massScale = all<W>(1.0f), impulseScale{};
        if constexpr (kWithBias) {
            const auto fixed = row(block.againstFixed, part) > F{};
            const Softness &hard = step.againstFixed, &soft = step.betweenBodies;
            massScale = select<W>(fixed, all<W>(hard.massScale), all<W>(soft.massScale));
            impulseScale = select<W>(fixed, all<W>(hard.impulseScale), all<W>(soft.impulseScale));
            const auto isShared = row(block.sharedMassScale, part) > F{};
            if (bitsOf<W>(isShared) != 0) {
                massScale = select<W>(isShared, row(block.sharedMassScale, part), massScale);
                impulseScale = select<W>(isShared, row(block.sharedImpulseScale, part), impulseScale);
            }
            biasRate = select<W>(fixed, all<W>(hard.biasRate), all<W>(soft.biasRate)) * massScale;
        }
        const F inverseSubStep = all<W>(1.0f / step.subStep);
        F normalSpeed[4], separations[4];
        for (int i = 0; i < points; ++i) {
            const V position = row(block.points[i].position, part);
            normalSpeed[i] = speed + dot<W>(position, speedSlope);
            separations[i] =
                row(block.points[i].separation, part) + separationChange + dot<W>(position, separationSlope);
        }

        F residuals[4]{};
        for (int i = 0; i < points; ++i) {
            const F impulse = row(block.points[i].impulse, part);
            const F residual = normalSpeed[i] + greater<W>(separations[i], F{}) * inverseSubStep;
            const auto pushes = ((impulse > F{}) | (residual < F{})) & (row(block.points[i].effectiveMass, part) > F{});
            residuals[i] = select<W>(kWithBias ? pushes : pushes & ~isIdle(separations[i], impulse), residual, F{});
        }
        NormalImpulse impulses;
        const Masks<W> isImpact = ImpactKernels<W>::impacts(residuals);
        if (bitsOf<W>(isImpact) != 0) {
            impulses = ImpactKernels<W>::solve(block, part, points, isImpact, residuals, normalSpeed);
        }

        Load load;
        for (int i = 0; i < points; ++i) {
            PointRows& point = block.points[i];
            const F mass = row(point.effectiveMass, part), before = row(point.impulse, part);
            const F separation = separations[i];
            F reduction;  // of the impulse
            if constexpr (kWithBias) {
                const auto isApart = separation > F{};
                const F bias = select<W>(isApart, separation * inverseSubStep,
                                         greater<W>(biasRate * separation, all<W>(-step.pushOutSpeed)));
                reduction = mass * (select<W>(isApart, all<W>(1.0f), massScale) * normalSpeed[i] + bias) +
                            select<W>(isApart, F{}, impulseScale) * before;
            } else {
                const F slowed = mass * (normalSpeed[i] + greater<W>(separation, F{}) * inverseSubStep);
                reduction = select<W>(isIdle(separation, before), F{}, slowed);
            }
            const F after = greater<W>(before - reduction, F{}), change = after - before;
            put(after, point.impulse, part);
            impulses.sum = impulses.sum + change;
            impulses.moment = impulses.moment + row(point.position, part) * change;
            for (int j = i + 1; j < points; ++j) {
                normalSpeed[j] = normalSpeed[j] + row(block.coupling[couplingIndex(i, j)], part) * change;
            }
            if constexpr (!kWithBias) {
                put(row(point.stepImpulse, part) + after, point.stepImpulse, part);
                load.sum = load.sum + after;
                load.leverage = load.leverage + row(point.lever, part) * after;
            }
        }
        apply(impulses, n, centreOffset, block, part, a, b);
        return load;
    }

    [[gnu::always_inline]] static void applyFriction(ContactBlock& block, int part, const Load& load, Velocities& a,
                                                     Velocities& b) {
        const V n = row(block.normal, part), centreOffset = row(block.centreOffset, part),
                centre = row(block.frictionCentre, part);
        const V tangent = row(block.tangent, part), other = cross<W>(n, tangent);
        const F friction = row(block.friction, part);

        const F twistBefore = row(block.twist, part), maxTwist = friction * load.leverage;
        F twist = twistBefore - row(block.twistMass, part) * dot<W>(n, b.angularVelocity - a.angularVelocity);
        twist = greater<W>(lesser<W>(twist, maxTwist), -maxTwist);
        put(twist, block.twist, part);
        applyTwist(twist - twistBefore, n, block, part, a, b);

        const V slip = b.linear + cross<W>(b.angularVelocity, centre + centreOffset) - a.linear -
                       cross<W>(a.angularVelocity, centre);
        const F slipX = dot<W>(slip, tangent), slipY = dot<W>(slip, other);
        const F xx = row(block.tangentMassXX, part), xy = row(block.tangentMassXY, part),
                yy = row(block.tangentMassYY, part);
        const F beforeX = row(block.frictionX, part), beforeY = row(block.frictionY, part);
        F x = beforeX - (xx * slipX + xy * slipY), y = beforeY - (xy * slipX + yy * slipY);
        const F limit = friction * load.sum, size = x * x + y * y;
        const auto isSliding = size > limit * limit;
        const F scale =
            select<W>(isSliding, limit / squareRoot<W>(select<W>(isSliding, size, all<W>(1.0f))), all<W>(1.0f));
        x = x * scale;
        y = y * scale;
        put(x, block.frictionX, part);
        put(y, block.frictionY, part);
        applyAt(tangent * (x - beforeX) + other * (y - beforeY), centre, centreOffset, block, part, a, b);
    }

    template <bool kWithBias>
    static void pass(std::span<ContactBlock> blocks, const SolverStep& step) {
        for (ContactBlock& block : blocks) {
            for (int part = 0; part < kBlockLanes / W; ++part) {
                const int points = maxPointCount(block, part);
                if (points == 0) continue;
                const Motions from = motions(block.first, part, step), to = motions(block.second, part, step);
                Velocities a = from, b = to;
                const Load load = applyNormalImpulses<kWithBias>(block, part, points, step, from, a, to, b);
                if constexpr (!kWithBias) applyFriction(block, part, load, a, b);
                putVelocities(a, block.first, part, step);
                putVelocities(b, block.second, part, step);
            }
        }
    }
    static void solve(std::span<ContactBlock> blocks, const SolverStep& step) { pass<true>(blocks, step); }
    static void relax(std::span<ContactBlock> blocks, const SolverStep& step) { pass<false>(blocks, step); }

    static void restitute(std::span<ContactBlock> blocks, const SolverStep& step) {
        for (ContactBlock& block : blocks) {
            for (int part = 0; part < kBlockLanes / W; ++part) {
                const F restitution = row(block.restitution, part);
                const int points = maxPointCount(block, part);
                if (points == 0 || bitsOf<W>(restitution > F{}) == 0) continue;
                Velocities a = velocities(block.first, part, step), b = velocities(block.second, part, step);
                restoreTogether(block, part, points, restitution, step, a, b);
                applyRestitution(block, part, points, restitution, step, a, b);
                putVelocities(a, block.first, part, step);
                putVelocities(b, block.second, part, step);
            }
        }
    }

    /// Restores the speeds of all points that were hit together, where none of them would have to pull.
    [[gnu::always_inline]] static void restoreTogether(ContactBlock& block, int part, int points, F restitution,
                                                       const SolverStep& step, Velocities& a, Velocities& b) {
        const V n = row(block.normal, part), centreOffset = row(block.centreOffset, part);
        const V spinA = cross<W>(n, a.angularVelocity), spinB = cross<W>(n, b.angularVelocity);
        const F speed = dot<W>(n, b.linear - a.linear) + dot<W>(centreOffset, spinB);
        F residuals[4]{}, speeds[4]{}, impulses[4]{};
        for (int i = 0; i < points; ++i) {
            const PointRows& point = block.points[i];
            impulses[i] = row(point.impulse, part);
            const F approach = row(point.approach, part);
            // Points that only came near were not hit.
            const auto isHit = (approach < all<W>(-step.restitutionSpeed)) & (row(point.stepImpulse, part) > F{}) &
                               (restitution > F{});
            speeds[i] = speed + dot<W>(row(point.position, part), spinB - spinA);
            residuals[i] = select<W>(isHit, speeds[i] + restitution * approach, F{});
        }
        const auto isImpact = ImpactKernels<W>::impacts(residuals);
        apply(ImpactKernels<W>::solve(block, part, points, isImpact, residuals, speeds), n, centreOffset, block, part,
              a, b);
        for (int i = 0; i < points; ++i) {
            PointRows& point = block.points[i];
            put(row(point.stepImpulse, part) + (row(point.impulse, part) - impulses[i]), point.stepImpulse, part);
        }
    }

    [[gnu::always_inline]] static void applyRestitution(ContactBlock& block, int part, int points, F restitution,
                                                        const SolverStep& step, Velocities& a, Velocities& b) {
        const V n = row(block.normal, part), centreOffset = row(block.centreOffset, part);
        for (int round = 0; round < kRestitutionIterations * points; ++round) {
            const int i = round % points;
            PointRows& point = block.points[i];
            const V position = row(point.position, part);
            const F approach = row(point.approach, part), stepImpulse = row(point.stepImpulse, part);
            // Points that only came near were not hit.
            const auto hit = (approach < all<W>(-step.restitutionSpeed)) & (stepImpulse > F{}) & (restitution > F{});
            const V spinA = cross<W>(n, a.angularVelocity), spinB = cross<W>(n, b.angularVelocity);
            const F speed =
                dot<W>(n, b.linear - a.linear) + dot<W>(centreOffset, spinB) + dot<W>(position, spinB - spinA);
            const F before = row(point.impulse, part);
            F after = greater<W>(before - row(point.effectiveMass, part) * (speed + restitution * approach), F{});
            after = select<W>(hit, after, before);
            const F change = after - before;
            put(after, point.impulse, part);
            put(stepImpulse + change, point.stepImpulse, part);
            apply({change, position * change}, n, centreOffset, block, part, a, b);
        }
    }
};

}  // namespace rubble
