#pragma once

#include "core/physics/solver/ImpactKernels.h"

// Friction of a manifold, after Coulomb, at one point: the friction centre c. The impulses are accumulated and clamped,
// as the normal ones are (Catto 2005, "Iterative dynamics with temporal coherence").
//     f  N·s    impulse along both tangents: frictionX, frictionY
//     τ  N·m·s  torsional impulse about the normal n: torsionalImpulse
//     u  m/s    slip, the tangential velocity of B relative to A at c
//     M  kg     effective mass of both tangents at c, 2 x 2: tangentMassXX, tangentMassXY, tangentMassYY
//     J  kg·m²  effective inertia about n: torsionalMass
//     μ         coefficient of friction
//     λ  N·s    normal impulses of the points; l, m, their distances from c: lever
//
//     τ' = clamp(τ - J n . (wB - wA), ± μ Σ λ l)
//     f' = f - M u, shortened to at most μ Σ λ

namespace rubble {

/// The passes of a sub-step that apply normal impulses.
enum class ContactPass {
    Solve,   // with the bias of soft contacts
    Relax,   // without bias, and friction
    Settle,  // as Relax, again for some manifolds
};

/// The friction of manifolds.
template <int W>
struct FrictionKernels : ContactLanes<W> {
    using Lanes = ContactLanes<W>;
    using F = typename Lanes::F;
    using V = typename Lanes::V;
    using Lanes::applyAt;
    using Lanes::applyTorsionalImpulse;
    using Lanes::put;
    using Lanes::row;
    using typename Lanes::Velocities;

    /// The normal impulses that limit friction.
    struct Load {
        F sum{};       // N·s: Σ λ
        F leverage{};  // N·m·s: Σ λ l, which limits torsional friction at a coefficient of 1
    };

    /// The factor that shortens a vector of squared length `squared` to at most `limit`, for the lanes of a mask.
    [[gnu::always_inline]] static F shortening(Masks<W> isBeyond, F squared, F limit) {
        return select<W>(isBeyond, limit / squareRoot<W>(select<W>(isBeyond, squared, all<W>(1.0f))), all<W>(1.0f));
    }

    /// Applies the friction of the last sub-step.
    [[gnu::always_inline]] static void warmStart(const ContactBlock& block, int part, const V& n, const V& centreOffset,
                                                 Velocities& a, Velocities& b) {
        const V t = row(block.tangent, part);
        const V impulse = t * row(block.frictionX, part) + cross<W>(n, t) * row(block.frictionY, part);
        applyAt(impulse, row(block.frictionCentre, part), centreOffset, block, part, a, b);
        applyTorsionalImpulse(row(block.torsionalImpulse, part), n, block, part, a, b);
    }

    /// Takes back the friction that warm starting applied beyond its limit, for the manifolds of a mask: that of an
    /// impact says nothing about the next sub-step. Reduced only after the normal impulses, it would change the normal
    /// speeds of slender bodies, and so add energy. Returns the manifolds that it changed.
    [[gnu::always_inline]] static Masks<W> trim(ContactBlock& block, int part, int points, Masks<W> mask, const V& n,
                                                const V& centreOffset, Velocities& a, Velocities& b) {
        F load{};
        for (int i = 0; i < points; ++i) load = load + row(block.points[i].impulse, part);
        const V t = row(block.tangent, part);
        const F x = row(block.frictionX, part), y = row(block.frictionY, part), size = x * x + y * y;
        const F limit = row(block.friction, part) * load;
        const Masks<W> isBeyond = mask & (size > limit * limit);
        if (bitsOf<W>(isBeyond) == 0) return isBeyond;
        const F kept = shortening(isBeyond, size, limit);
        const F torsional = row(block.torsionalImpulse, part);
        const F lessX = x * kept - x, lessY = y * kept - y, lessTorsional = torsional * kept - torsional;
        applyAt(t * lessX + cross<W>(n, t) * lessY, row(block.frictionCentre, part), centreOffset, block, part, a, b);
        applyTorsionalImpulse(lessTorsional, n, block, part, a, b);
        put(x + lessX, block.frictionX, part);
        put(y + lessY, block.frictionY, part);
        put(torsional + lessTorsional, block.torsionalImpulse, part);
        return isBeyond;
    }

    /// Applies torsional friction, then tangential. `mask`: the manifolds that ContactPass::Settle solves. Returns the
    /// manifolds whose tangential speed changed like in an impact.
    template <ContactPass kPass>
    [[gnu::always_inline]] static Masks<W> applyFriction(ContactBlock& block, int part, const Load& load, Velocities& a,
                                                         Velocities& b, Masks<W> mask) {
        const V n = row(block.normal, part);
        const F friction = row(block.friction, part);
        applyTorsional<kPass>(block, part, n, friction * load.leverage, a, b, mask);
        return applyTangential<kPass>(block, part, n, friction * load.sum, a, b, mask);
    }

private:
    template <ContactPass kPass>
    [[gnu::always_inline]] static void applyTorsional(ContactBlock& block, int part, const V& n, F limit, Velocities& a,
                                                      Velocities& b, Masks<W> mask) {
        const F before = row(block.torsionalImpulse, part);
        F after =
            before - row(block.torsionalMass, part) * dot<W>(n, b.angularVelocity - a.angularVelocity);  // τ - J w
        after = greater<W>(lesser<W>(after, limit), -limit);  // ± μ Σ λ l
        if constexpr (kPass == ContactPass::Settle) after = select<W>(mask, after, before);
        put(after, block.torsionalImpulse, part);
        addToStep<kPass>(before, after, block.stepTorsionalImpulse, part);
        applyTorsionalImpulse(after - before, n, block, part, a, b);
    }

    /// ContactPass::Relax adds the impulse of its sub-step, Settle what it changes.
    template <ContactPass kPass>
    [[gnu::always_inline]] static void addToStep(F before, F after, FloatRow& sum, int part) {
        put(row(sum, part) + (kPass == ContactPass::Relax ? after : after - before), sum, part);
    }

    template <ContactPass kPass>
    [[gnu::always_inline]] static Masks<W> applyTangential(ContactBlock& block, int part, const V& n, F limit,
                                                           Velocities& a, Velocities& b, Masks<W> mask) {
        const V centre = row(block.frictionCentre, part), centreOffset = row(block.centreOffset, part);
        const V tangent = row(block.tangent, part), other = cross<W>(n, tangent);
        const V slip = b.linear + cross<W>(b.angularVelocity, centre + centreOffset) - a.linear -
                       cross<W>(a.angularVelocity, centre);  // u
        const F slipX = dot<W>(slip, tangent), slipY = dot<W>(slip, other);
        const F xx = row(block.tangentMassXX, part), xy = row(block.tangentMassXY, part),
                yy = row(block.tangentMassYY, part);  // M
        const F beforeX = row(block.frictionX, part), beforeY = row(block.frictionY, part);
        F x = beforeX - (xx * slipX + xy * slipY), y = beforeY - (xy * slipX + yy * slipY);  // f - M u
        const F size = x * x + y * y;
        const F scale = shortening(size > limit * limit, size, limit);  // μ Σ λ / |f - M u|
        x = x * scale;
        y = y * scale;
        if constexpr (kPass == ContactPass::Settle) {
            x = select<W>(mask, x, beforeX);
            y = select<W>(mask, y, beforeY);
        }
        put(x, block.frictionX, part);
        put(y, block.frictionY, part);
        addToStep<kPass>(beforeX, x, block.stepFrictionX, part);
        addToStep<kPass>(beforeY, y, block.stepFrictionY, part);
        const F changeX = x - beforeX, changeY = y - beforeY;
        applyAt(tangent * changeX + other * changeY, centre, centreOffset, block, part, a, b);
        const F least = ImpactKernels<W>::kMinSpeed * lesser<W>(xx, yy);
        return changeX * changeX + changeY * changeY > least * least;
    }
};

}  // namespace rubble
