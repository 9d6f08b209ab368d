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
//     f' = f - M u               if it is at most μ Σ λ
//     f' = (1 + s M)⁻¹ (f - M u)  else, with the s > 0, 1/kg, that makes it so long
//
// The slip that friction leaves is -s f': friction at its limit acts against the slip, whatever the masses along both
// tangents are (the principle of maximum dissipation; Moreau 1970). Scaling f - M u instead would make it act along
// M u.

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

    /// Replaces p = f - M u, where it is longer than `limit`, by (1 + s M)⁻¹ p of that length. 1/|f'| is nearly
    /// linear in s; one step of Newton's method from the s of a mass that is the same in all directions finds the
    /// direction within half a degree for masses that differ by 1 : 7, and exactly for equal ones. With p of length 1
    /// and the limit ρ, with D the determinant of 1 + s M and F = D f':
    ///     s' = s + F² (|F| - ρ D) / (ρ (F M F + s det M F²))
    /// Source: Moré, Sorensen 1983, "Computing a trust region step".
    [[gnu::always_inline]] static void limitToCone(F xx, F xy, F yy, F limit, F& x, F& y) {
        constexpr float kMinFraction = 1e-6f;  // of p: where the limit is less, the direction hardly depends on it
        const F size = x * x + y * y;
        const Masks<W> isLoaded = limit > F{}, isBeyond = isLoaded & (size > limit * limit);
        x = select<W>(isLoaded, x, F{});  // many points are only near
        y = select<W>(isLoaded, y, F{});
        if (bitsOf<W>(isBeyond) == 0) return;
        const F inverseLength = inverseOrZero<W>(squareRoot<W>(size)), px = x * inverseLength, py = y * inverseLength;
        const F least = greater<W>(limit * inverseLength, all<W>(kMinFraction));  // ρ
        const F determinant = greater<W>(xx * yy - xy * xy, F{});
        const F adjX = yy * px - xy * py, adjY = xx * py - xy * px;  // det M · M⁻¹ p
        const F massAlong = px * (xx * px + xy * py) + py * (xy * px + yy * py);
        F s = (1.0f - least) * inverseOrZero<W>(least * massAlong);
        F fx = px + s * adjX, fy = py + s * adjY, squared = fx * fx + fy * fy;
        const F excess = squareRoot<W>(squared) - least * (1.0f + s * (xx + yy + s * determinant));
        const F slope = fx * (xx * fx + xy * fy) + fy * (xy * fx + yy * fy) + s * determinant * squared;
        s = greater<W>(s + squared * excess * inverseOrZero<W>(least * slope), F{});
        fx = px + s * adjX;
        fy = py + s * adjY;
        const F scale = limit * inverseOrZero<W>(squareRoot<W>(fx * fx + fy * fy));
        x = select<W>(isBeyond, fx * scale, x);
        y = select<W>(isBeyond, fy * scale, y);
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
        limitToCone(xx, xy, yy, limit, x, y);
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
