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
    using Lanes::applyTorsionalImpulse;
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
                applyTorsionalImpulse(row(block.torsionalImpulse, part), n, block, part, a, b);
                putVelocities(a, block.first, part, step);
                putVelocities(b, block.second, part, step);
            }
        }
    }

    enum class Pass {
        Solve,   // normal impulses with the bias of soft contacts
        Relax,   // normal impulses without bias, and friction
        Settle,  // the same again for some manifolds
    };

    /// The normal impulses that limit friction.
    struct Load {
        F sum{};       // N·s
        F leverage{};  // N·m·s: sum of impulse times lever, which limits torsional friction at a coefficient of 1
    };

    /// A point without contact and impulse is left to the next sub-step: slowing it down now would reduce the impact
    /// measured by the next step.
    [[gnu::always_inline]] static Masks<W> isIdle(F separation, F impulse) {
        return (separation > all<W>(kTouching)) & (impulse <= F{});
    }

    /// The impulses of the manifolds of a mask, none of others.
    [[gnu::always_inline]] static NormalImpulse only(Masks<W> mask, const NormalImpulse& impulses) {
        return {select<W>(mask, impulses.sum, F{}),
                {select<W>(mask, impulses.moment.x, F{}), select<W>(mask, impulses.moment.y, F{}),
                 select<W>(mask, impulses.moment.z, F{})}};
    }

    /// The speeds of the points along the normal, m/s, negative where they approach.
    [[gnu::always_inline]] static void computeNormalSpeeds(const ContactBlock& block, int part, int points, const V& n,
                                                           const V& centreOffset, const Velocities& a,
                                                           const Velocities& b, F* speeds) {
        const V spinA = cross<W>(n, a.angularVelocity), spinB = cross<W>(n, b.angularVelocity);
        const V slope = spinB - spinA;
        const F speed = dot<W>(n, b.linear - a.linear) + dot<W>(centreOffset, spinB);
        for (int i = 0; i < points; ++i) speeds[i] = speed + dot<W>(row(block.points[i].position, part), slope);
    }

    /// Takes back the friction that warm starting applied beyond its limit, for the manifolds of a mask: that of an
    /// impact says nothing about the next sub-step. Reduced only after the normal impulses, it would change the normal
    /// speeds of slender bodies, and so add energy. Returns the manifolds that it changed.
    [[gnu::always_inline]] static Masks<W> trimFriction(ContactBlock& block, int part, int points, Masks<W> mask,
                                                        const V& n, const V& centreOffset, Velocities& a,
                                                        Velocities& b) {
        F load{};
        for (int i = 0; i < points; ++i) load = load + row(block.points[i].impulse, part);
        const V t = row(block.tangent, part);
        const F x = row(block.frictionX, part), y = row(block.frictionY, part), size = x * x + y * y;
        const F limit = row(block.friction, part) * load;
        const Masks<W> isBeyond = mask & (size > limit * limit);
        if (bitsOf<W>(isBeyond) == 0) return isBeyond;
        const F kept =
            select<W>(isBeyond, limit / squareRoot<W>(select<W>(isBeyond, size, all<W>(1.0f))), all<W>(1.0f));
        const F torsional = row(block.torsionalImpulse, part);
        const F lessX = x * kept - x, lessY = y * kept - y, lessTorsional = torsional * kept - torsional;
        applyAt(t * lessX + cross<W>(n, t) * lessY, row(block.frictionCentre, part), centreOffset, block, part, a, b);
        applyTorsionalImpulse(lessTorsional, n, block, part, a, b);
        put(x + lessX, block.frictionX, part);
        put(y + lessY, block.frictionY, part);
        put(torsional + lessTorsional, block.torsionalImpulse, part);
        return isBeyond;
    }

    /// `mask`: the manifolds that Pass::Settle solves.
    template <Pass kPass>
    [[gnu::always_inline]] static Load applyNormalImpulses(ContactBlock& block, int part, int points,
                                                           const SolverStep& step, const Motions& from, Velocities& a,
                                                           const Motions& to, Velocities& b, Masks<W> mask) {
        const V n = row(block.normal, part), centreOffset = row(block.centreOffset, part);
        const V nA = rotated<W>(from.deltaRotation.conjugate(), n) - n,
                nB = rotated<W>(to.deltaRotation.conjugate(), n) - n;
        const F separationChange = dot<W>(n, to.deltaPosition - from.deltaPosition) + dot<W>(centreOffset, nB);
        const V separationSlope = nB - nA;

        F biasRate{}, massScale = all<W>(1.0f), impulseScale{}, stiffening{};
        if constexpr (kPass == Pass::Solve) {
            const auto fixed = row(block.againstFixed, part) > F{};
            const Softness &hard = step.againstFixed, &soft = step.betweenBodies;
            massScale = select<W>(fixed, all<W>(hard.massScale), all<W>(soft.massScale));
            impulseScale = select<W>(fixed, all<W>(hard.impulseScale), all<W>(soft.impulseScale));
            stiffening = row(block.stiffening, part);
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
            separations[i] =
                row(block.points[i].separation, part) + separationChange + dot<W>(position, separationSlope);
        }
        computeNormalSpeeds(block, part, points, n, centreOffset, a, b, normalSpeed);

        F residuals[4]{}, unsettled[4]{};
        for (int i = 0; i < points; ++i) unsettled[i] = row(block.points[i].impulse, part);
        const auto computeResiduals = [&] {
            for (int i = 0; i < points; ++i) {
                const F impulse = row(block.points[i].impulse, part);
                const F residual = normalSpeed[i] + greater<W>(separations[i], F{}) * inverseSubStep;
                const auto pushes =
                    ((impulse > F{}) | (residual < F{})) & (row(block.points[i].effectiveMass, part) > F{});
                residuals[i] =
                    select<W>(kPass == Pass::Solve ? pushes : pushes & ~isIdle(separations[i], impulse), residual, F{});
            }
        };
        computeResiduals();
        NormalImpulse impulses;
        Masks<W> isImpact = ImpactKernels<W>::impacts(residuals);
        if constexpr (kPass == Pass::Settle) isImpact = isImpact & mask;
        if (bitsOf<W>(isImpact) != 0) {
            impulses = ImpactKernels<W>::solve(block, part, points, isImpact, residuals, normalSpeed);
            if constexpr (kPass == Pass::Solve) {
                const Masks<W> isTrimmed = trimFriction(block, part, points, isImpact, n, centreOffset, a, b);
                if (bitsOf<W>(isTrimmed) != 0) {
                    // Other lanes apply their impulses below: each lane does what it would do alone.
                    apply(only(isTrimmed, impulses), n, centreOffset, block, part, a, b);
                    F trimmedSpeed[4];
                    computeNormalSpeeds(block, part, points, n, centreOffset, a, b, trimmedSpeed);
                    for (int i = 0; i < points; ++i) {
                        normalSpeed[i] = select<W>(isTrimmed, trimmedSpeed[i], normalSpeed[i]);
                    }
                    computeResiduals();
                    const NormalImpulse again =
                        ImpactKernels<W>::solve(block, part, points, isTrimmed, residuals, normalSpeed);
                    impulses = only(~isTrimmed, impulses);
                    impulses.sum = impulses.sum + again.sum;
                    impulses.moment = impulses.moment + again.moment;
                }
            }
        }

        Load load;
        for (int i = 0; i < points; ++i) {
            PointRows& point = block.points[i];
            const F mass = row(point.effectiveMass, part), before = row(point.impulse, part);
            const F separation = separations[i];
            F reduction;  // of the impulse
            if constexpr (kPass == Pass::Solve) {
                const auto isApart = separation > F{};
                const F bias = select<W>(isApart, separation * inverseSubStep,
                                         greater<W>(biasRate * separation, all<W>(-step.pushOutSpeed)));
                // A contact that overlaps deeply releases less of its impulse, down to nothing: it is rigid.
                const F released =
                    impulseScale * lesser<W>(greater<W>(2.0f + separation * stiffening, F{}), all<W>(1.0f));
                reduction = mass * (select<W>(isApart, all<W>(1.0f), massScale) * normalSpeed[i] + bias) +
                            select<W>(isApart, F{}, released) * before;
            } else {
                const F slowed = mass * (normalSpeed[i] + greater<W>(separation, F{}) * inverseSubStep);
                reduction = select<W>(isIdle(separation, before), F{}, slowed);
            }
            F after = greater<W>(before - reduction, F{});
            if constexpr (kPass == Pass::Settle) after = select<W>(mask, after, before);
            const F change = after - before;
            put(after, point.impulse, part);
            impulses.sum = impulses.sum + change;
            impulses.moment = impulses.moment + row(point.position, part) * change;
            for (int j = i + 1; j < points; ++j) {
                normalSpeed[j] = normalSpeed[j] + row(block.coupling[couplingIndex(i, j)], part) * change;
            }
            if constexpr (kPass != Pass::Solve) {
                // Pass::Relax adds the impulse of its sub-step, Pass::Settle what it changes.
                const F added = kPass == Pass::Relax ? after : after - unsettled[i];
                put(row(point.stepImpulse, part) + added, point.stepImpulse, part);
                load.sum = load.sum + after;
                load.leverage = load.leverage + row(point.lever, part) * after;
            }
        }
        apply(impulses, n, centreOffset, block, part, a, b);
        return load;
    }

    /// Returns the manifolds whose friction changed the tangential speed like an impact.
    template <Pass kPass>
    [[gnu::always_inline]] static Masks<W> applyFriction(ContactBlock& block, int part, const Load& load, Velocities& a,
                                                         Velocities& b, Masks<W> mask) {
        const V n = row(block.normal, part), centreOffset = row(block.centreOffset, part),
                centre = row(block.frictionCentre, part);
        const V tangent = row(block.tangent, part), other = cross<W>(n, tangent);
        const F friction = row(block.friction, part);

        const F torsionalBefore = row(block.torsionalImpulse, part), maxTorsional = friction * load.leverage;
        F torsional =
            torsionalBefore - row(block.torsionalMass, part) * dot<W>(n, b.angularVelocity - a.angularVelocity);
        torsional = greater<W>(lesser<W>(torsional, maxTorsional), -maxTorsional);
        if constexpr (kPass == Pass::Settle) torsional = select<W>(mask, torsional, torsionalBefore);
        put(torsional, block.torsionalImpulse, part);
        applyTorsionalImpulse(torsional - torsionalBefore, n, block, part, a, b);

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
        if constexpr (kPass == Pass::Settle) {
            x = select<W>(mask, x, beforeX);
            y = select<W>(mask, y, beforeY);
        }
        put(x, block.frictionX, part);
        put(y, block.frictionY, part);
        const F changeX = x - beforeX, changeY = y - beforeY;
        applyAt(tangent * changeX + other * changeY, centre, centreOffset, block, part, a, b);
        const F least = ImpactKernels<W>::kMinSpeed * lesser<W>(xx, yy);
        return changeX * changeX + changeY * changeY > least * least;
    }

    /// Solves normal impulses and friction alternately where friction changed the speeds like an impact. Friction and
    /// normal impulses of a slender body sustain each other; solved once each, they would leave speeds that add energy.
    static void settleImpacts(ContactBlock& block, int part, int points, const SolverStep& step, Motions& a, Motions& b,
                              Masks<W> mask) {
        constexpr int kRounds = 8;
        for (int round = 0; round < kRounds && bitsOf<W>(mask) != 0; ++round) {
            const Load load = applyNormalImpulses<Pass::Settle>(block, part, points, step, a, a, b, b, mask);
            mask = mask & applyFriction<Pass::Settle>(block, part, load, a, b, mask);
        }
    }

    template <Pass kPass>
    static void pass(std::span<ContactBlock> blocks, const SolverStep& step) {
        for (ContactBlock& block : blocks) {
            for (int part = 0; part < kBlockLanes / W; ++part) {
                const int points = maxPointCount(block, part);
                if (points == 0) continue;
                Motions a = motions(block.first, part, step), b = motions(block.second, part, step);
                const Load load = applyNormalImpulses<kPass>(block, part, points, step, a, a, b, b, Masks<W>{});
                if constexpr (kPass == Pass::Relax) {
                    const Masks<W> isImpact = applyFriction<kPass>(block, part, load, a, b, Masks<W>{});
                    if (bitsOf<W>(isImpact) != 0) settleImpacts(block, part, points, step, a, b, isImpact);
                }
                putVelocities(a, block.first, part, step);
                putVelocities(b, block.second, part, step);
            }
        }
    }
    static void solve(std::span<ContactBlock> blocks, const SolverStep& step) { pass<Pass::Solve>(blocks, step); }
    static void relax(std::span<ContactBlock> blocks, const SolverStep& step) { pass<Pass::Relax>(blocks, step); }

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
