#pragma once

#include "core/physics/solver/FrictionKernels.h"

// The soft contact step of a point, in the terms of Catto 2011, "Soft constraints", and Catto 2024, "Solver2D":
//     λ  N·s   accumulated normal impulse, >= 0: impulse
//     v  m/s   normal speed, negative where the bodies approach
//     s  m     current separation, negative where they overlap
//     m  kg    effective mass along the normal: effectiveMass
//     h  s     sub-step: subStep
//     β  1/s   bias rate      β = ω / (2ζ + hω)     of a spring of angular frequency ω and damping ratio ζ,
//     α        mass scale     α = hωa / (1 + hωa)   integrated implicitly, with a = 2ζ + hω: Softness,
//     γ        impulse scale  γ = 1 / (1 + hωa)     or, for α and γ, those of a shared load (SharedLoad.h)
//     r        the part of γ that is released: 1, but down to 0 where a contact overlaps deeply, which makes it rigid
//     p  m/s   the fastest that overlaps are resolved: pushOutSpeed
//
//     Solve, s > 0     λ' = max(λ - m (v + s/h), 0)             speculative: the gap may close within h, no more
//            s <= 0    λ' = max(λ - (m (α v + b) + γ r λ), 0)   with the bias velocity b = max(α β s, -p)
//     Relax            λ' = max(λ - m (v + max(s, 0)/h), 0)     takes back the velocity that b added
//
// Where points collide, they are solved together first (ImpactKernels). PrepareKernels.h has the geometry, and
// FrictionKernels.h friction, which Relax applies.

namespace rubble {

/// The passes of a sub-step that apply impulses: warm start, solve and relax.
template <int W>
struct SoftContactKernels : ContactLanes<W> {
    using Lanes = ContactLanes<W>;
    using Friction = FrictionKernels<W>;
    using F = typename Lanes::F;
    using V = typename Lanes::V;
    using Lanes::apply;
    using Lanes::maxPointCount;
    using Lanes::motions;
    using Lanes::normalSpeed;
    using Lanes::put;
    using Lanes::putVelocities;
    using Lanes::row;
    using Lanes::velocities;
    using typename Lanes::Motions;
    using typename Lanes::NormalImpulse;
    using typename Lanes::Velocities;
    using Load = typename Friction::Load;

    // m: separations below it are rounding. In a step of 1/1000 s, impacts as far ahead are measured.
    static constexpr float kTouching = 2e-5f;

    static void warmStart(std::span<ContactBlock> blocks, const SolverStep& step) {
        for (ContactBlock& block : blocks) {
            for (int part = 0; part < kBlockLanes / W; ++part) {
                const int points = maxPointCount(block, part);
                if (points == 0) continue;
                Velocities a = velocities(block.first, part, step), b = velocities(block.second, part, step);
                const V n = row(block.normal, part), centreOffset = row(block.centreOffset, part);
                NormalImpulse impulses;
                for (int i = 0; i < points; ++i)
                    add(row(block.points[i].impulse, part), block.points[i], part, impulses);
                apply(impulses, n, centreOffset, block, part, a, b);
                Friction::warmStart(block, part, n, centreOffset, a, b);
                putVelocities(a, block.first, part, step);
                putVelocities(b, block.second, part, step);
            }
        }
    }
    static void solve(std::span<ContactBlock> blocks, const SolverStep& step) {
        pass<ContactPass::Solve>(blocks, step);
    }
    static void relax(std::span<ContactBlock> blocks, const SolverStep& step) {
        pass<ContactPass::Relax>(blocks, step);
    }

private:
    /// The points of W manifolds during a pass: arrays only, and so in memory; what a register can hold is not here.
    struct Points {
        F separation[4];  // m: s
        F speed[4];       // m/s: v
    };

    /// The coefficients of W manifolds.
    struct Coefficients {
        F biasRate{};                // α β
        F massScale = all<W>(1.0f);  // α
        F impulseScale{};            // γ
        F stiffening{};              // 1/m
    };

    template <ContactPass kPass>
    static void pass(std::span<ContactBlock> blocks, const SolverStep& step) {
        for (ContactBlock& block : blocks) {
            for (int part = 0; part < kBlockLanes / W; ++part) {
                const int points = maxPointCount(block, part);
                if (points == 0) continue;
                Motions a = motions(block.first, part, step), b = motions(block.second, part, step);
                const Load load = applyNormalImpulses<kPass>(block, part, points, step, a, b, Masks<W>{});
                if constexpr (kPass == ContactPass::Relax) {
                    const Masks<W> isImpact =
                        Friction::template applyFriction<kPass>(block, part, load, a, b, Masks<W>{});
                    if (bitsOf<W>(isImpact) != 0) settleImpacts(block, part, points, step, a, b, isImpact);
                    const Masks<W> wasImpact = row(block.points[0].sustained, part) >= F{};
                    if (bitsOf<W>(wasImpact) != 0) forgetImpacts(block, part, points, wasImpact);
                }
                putVelocities(a, block.first, part, step);
                putVelocities(b, block.second, part, step);
            }
        }
    }

    /// Solves normal impulses and friction alternately where friction changed the speeds like an impact. Friction and
    /// normal impulses of a slender body sustain each other; solved once each, they would leave speeds that add energy.
    static void settleImpacts(ContactBlock& block, int part, int points, const SolverStep& step, Motions& a, Motions& b,
                              Masks<W> mask) {
        constexpr int kRounds = 8;
        constexpr auto kSettle = ContactPass::Settle;
        for (int round = 0; round < kRounds && bitsOf<W>(mask) != 0; ++round) {
            const Load load = applyNormalImpulses<kSettle>(block, part, points, step, a, b, mask);
            mask = mask & Friction::template applyFriction<kSettle>(block, part, load, a, b, mask);
        }
    }

    /// Notes the impulses that manifolds had before the first impact of a sub-step.
    static void rememberSustained(ContactBlock& block, int part, int points, Masks<W> isImpact, const F* before) {
        isImpact = isImpact & ~(row(block.points[0].sustained, part) >= F{});
        for (int i = 0; i < points; ++i) {
            FloatRow& sustained = block.points[i].sustained;
            put(select<W>(isImpact, before[i], row(sustained, part)), sustained, part);
        }
    }
    /// Limits what the next sub-step warm starts with to the impulses before the impact and half as much again, and a
    /// little more, so that a load can build up. The impulse that stopped a body would throw it; its own contact
    /// corrects that, but the contacts solved before take it for an approach and push.
    static void forgetImpacts(ContactBlock& block, int part, int points, Masks<W> wasImpact) {
        F sum{}, kept{};
        for (int i = 0; i < points; ++i) {
            PointRows& point = block.points[i];
            const F impulse = row(point.impulse, part);
            const F most = 1.5f * row(point.sustained, part) +
                           all<W>(ImpactKernels<W>::kMinSpeed) * row(point.effectiveMass, part);
            const F limited = select<W>(wasImpact, lesser<W>(impulse, most), impulse);
            put(limited, point.impulse, part);
            sum = sum + impulse;
            kept = kept + limited;
        }
        const F scale = select<W>(wasImpact, kept * inverseOrZero<W>(sum), all<W>(1.0f));
        for (FloatRow* friction : {&block.frictionX, &block.frictionY, &block.torsionalImpulse})
            put(row(*friction, part) * scale, *friction, part);
        FloatRow& flag = block.points[0].sustained;
        put(select<W>(wasImpact, all<W>(-1.0f), row(flag, part)), flag, part);
    }

    /// Solves the normal impulses of W manifolds. `mask`: the manifolds that ContactPass::Settle solves.
    template <ContactPass kPass>
    [[gnu::always_inline]] static Load applyNormalImpulses(ContactBlock& block, int part, int count,
                                                           const SolverStep& step, Motions& a, Motions& b,
                                                           Masks<W> mask) {
        const F inverseSubStep = all<W>(1.0f / step.subStep);
        const V n = row(block.normal, part), centreOffset = row(block.centreOffset, part);
        Points points = pointsOf(block, part, count, n, centreOffset, a, b);
        F unsettled[4]{};  // the impulses before the pass
        for (int i = 0; i < count; ++i) unsettled[i] = row(block.points[i].impulse, part);
        NormalImpulse impulses =
            solveImpacts<kPass>(block, part, count, points, n, centreOffset, inverseSubStep, a, b, mask, unsettled);
        const Load load =
            solvePoints<kPass>(block, part, count, points, step, inverseSubStep, mask, unsettled, impulses);
        apply(impulses, n, centreOffset, block, part, a, b);
        return load;
    }

    /// The current separations and speeds; PrepareKernels.h derives them.
    [[gnu::always_inline]] static Points pointsOf(const ContactBlock& block, int part, int count, const V& n,
                                                  const V& centreOffset, const Motions& a, const Motions& b) {
        Points points;
        const V nA = rotated<W>(a.deltaRotation.conjugate(), n) - n,
                nB = rotated<W>(b.deltaRotation.conjugate(), n) - n;
        const F change = dot<W>(n, b.deltaPosition - a.deltaPosition) + dot<W>(centreOffset, nB);
        const V slope = nB - nA;
        for (int i = 0; i < count; ++i) {
            const V position = row(block.points[i].position, part);
            points.separation[i] = row(block.points[i].separation, part) + change + dot<W>(position, slope);
        }
        computeSpeeds(block, part, a, b, n, centreOffset, count, points.speed);
        return points;
    }
    [[gnu::always_inline]] static void computeSpeeds(const ContactBlock& block, int part, const Velocities& a,
                                                     const Velocities& b, const V& n, const V& centreOffset, int count,
                                                     F* speeds) {
        const auto speed = normalSpeed(n, centreOffset, a, b);
        for (int i = 0; i < count; ++i) speeds[i] = speed.at(row(block.points[i].position, part));
    }

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
    [[gnu::always_inline]] static void add(F impulse, const PointRows& point, int part, NormalImpulse& impulses) {
        impulses.sum = impulses.sum + impulse;
        impulses.moment = impulses.moment + row(point.position, part) * impulse;
    }

    /// The speeds that an impact has to cancel: v + max(s, 0)/h of points that push, 0 of others.
    template <ContactPass kPass>
    [[gnu::always_inline]] static void computeResiduals(const ContactBlock& block, int part, int count,
                                                        const Points& points, F inverseSubStep, F* residuals) {
        for (int i = 0; i < count; ++i) {
            const F impulse = row(block.points[i].impulse, part);
            const F residual = points.speed[i] + greater<W>(points.separation[i], F{}) * inverseSubStep;
            const auto pushes = ((impulse > F{}) | (residual < F{})) & (row(block.points[i].effectiveMass, part) > F{});
            residuals[i] = select<W>(
                kPass == ContactPass::Solve ? pushes : pushes & ~isIdle(points.separation[i], impulse), residual, F{});
        }
    }

    /// Solves the points of manifolds that collide together. Returns the changes of the impulses; the bodies have not
    /// received them yet.
    template <ContactPass kPass>
    [[gnu::always_inline]] static NormalImpulse solveImpacts(ContactBlock& block, int part, int count, Points& points,
                                                             const V& n, const V& centreOffset, F inverseSubStep,
                                                             Velocities& a, Velocities& b, Masks<W> mask,
                                                             const F* before) {
        F residuals[4]{};
        computeResiduals<kPass>(block, part, count, points, inverseSubStep, residuals);
        Masks<W> isImpact = ImpactKernels<W>::impacts(residuals);
        if constexpr (kPass == ContactPass::Settle) isImpact = isImpact & mask;
        if (bitsOf<W>(isImpact) == 0) return {};
        if constexpr (kPass != ContactPass::Settle) rememberSustained(block, part, count, isImpact, before);
        NormalImpulse impulses = ImpactKernels<W>::solve(block, part, count, isImpact, residuals, points.speed);
        if constexpr (kPass == ContactPass::Solve) {
            const Masks<W> isTrimmed = Friction::trim(block, part, count, isImpact, n, centreOffset, a, b);
            if (bitsOf<W>(isTrimmed) == 0) return impulses;
            // Other lanes apply their impulses later: each lane does what it would do alone.
            apply(only(isTrimmed, impulses), n, centreOffset, block, part, a, b);
            F speeds[4];
            computeSpeeds(block, part, a, b, n, centreOffset, count, speeds);
            for (int i = 0; i < count; ++i) points.speed[i] = select<W>(isTrimmed, speeds[i], points.speed[i]);
            computeResiduals<kPass>(block, part, count, points, inverseSubStep, residuals);
            const NormalImpulse again = ImpactKernels<W>::solve(block, part, count, isTrimmed, residuals, points.speed);
            impulses = only(~isTrimmed, impulses);
            impulses.sum = impulses.sum + again.sum;
            impulses.moment = impulses.moment + again.moment;
        }
        return impulses;
    }

    [[gnu::always_inline]] static Coefficients coefficientsOf(const ContactBlock& block, int part,
                                                              const SolverStep& step) {
        Coefficients c;
        const Softness &againstFixed = step.againstFixed, &betweenBodies = step.betweenBodies;
        const auto isFixed = row(block.againstFixed, part) > F{};
        c.massScale = select<W>(isFixed, all<W>(againstFixed.massScale), all<W>(betweenBodies.massScale));
        c.impulseScale = select<W>(isFixed, all<W>(againstFixed.impulseScale), all<W>(betweenBodies.impulseScale));
        c.stiffening = row(block.stiffening, part);
        const auto isShared = row(block.sharedMassScale, part) > F{};
        if (bitsOf<W>(isShared) != 0) {
            c.massScale = select<W>(isShared, row(block.sharedMassScale, part), c.massScale);
            c.impulseScale = select<W>(isShared, row(block.sharedImpulseScale, part), c.impulseScale);
        }
        const F biasRate = select<W>(isFixed, all<W>(againstFixed.biasRate), all<W>(betweenBodies.biasRate));
        c.biasRate = biasRate * c.massScale;  // α β
        return c;
    }

    /// What the soft step takes from an impulse: m (v + s/h), or m (α v + b) + γ r λ.
    [[gnu::always_inline]] static F softReduction(const Coefficients& c, F mass, F speed, F separation, F impulse,
                                                  F inverseSubStep, float pushOutSpeed) {
        const auto isApart = separation > F{};
        const F bias = select<W>(isApart, separation * inverseSubStep,                         // s/h
                                 greater<W>(c.biasRate * separation, all<W>(-pushOutSpeed)));  // b = max(α β s, -p)
        const F massScale = select<W>(isApart, all<W>(1.0f), c.massScale);                     // 1 or α
        const F released = lesser<W>(greater<W>(2.0f + separation * c.stiffening, F{}), all<W>(1.0f));  // r
        return mass * (massScale * speed + bias) +                                                      // m (α v + b)
               select<W>(isApart, F{}, c.impulseScale * released) * impulse;                            // γ r λ
    }

    /// Solves the points one after the other: an impulse at one changes the speeds at the others. Adds the changes to
    /// `impulses`.
    template <ContactPass kPass>
    [[gnu::always_inline]] static Load solvePoints(ContactBlock& block, int part, int count, Points& points,
                                                   const SolverStep& step, F inverseSubStep, Masks<W> mask,
                                                   const F* unsettled, NormalImpulse& impulses) {
        Coefficients coefficients;
        if constexpr (kPass == ContactPass::Solve) coefficients = coefficientsOf(block, part, step);
        Load load;
        for (int i = 0; i < count; ++i) {
            PointRows& point = block.points[i];
            const F mass = row(point.effectiveMass, part), before = row(point.impulse, part);
            const F separation = points.separation[i], speed = points.speed[i];
            F reduction;
            if constexpr (kPass == ContactPass::Solve) {
                reduction =
                    softReduction(coefficients, mass, speed, separation, before, inverseSubStep, step.pushOutSpeed);
            } else {
                reduction = mass * (speed + greater<W>(separation, F{}) * inverseSubStep);  // m (v + max(s, 0)/h)
                reduction = select<W>(isIdle(separation, before), F{}, reduction);
            }
            F after = greater<W>(before - reduction, F{});  // λ'
            if constexpr (kPass == ContactPass::Settle) after = select<W>(mask, after, before);
            const F change = after - before;
            put(after, point.impulse, part);
            add(change, point, part, impulses);
            for (int j = i + 1; j < count; ++j) {
                points.speed[j] = points.speed[j] + row(block.coupling[couplingIndex(i, j)], part) * change;
            }
            if constexpr (kPass != ContactPass::Solve) {
                // Relax adds the impulse of its sub-step, Settle what it changes.
                const F added = kPass == ContactPass::Relax ? after : after - unsettled[i];
                put(row(point.stepImpulse, part) + added, point.stepImpulse, part);
                load.sum = load.sum + after;
                load.leverage = load.leverage + row(point.lever, part) * after;
            }
        }
        return load;
    }
};

}  // namespace rubble
