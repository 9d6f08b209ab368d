#pragma once

#include "core/physics/solver/ContactLanes.h"

// A contact's normal n points from the first body (A) to the second (B). A point at r from A's centre is at r + d from
// B's, with d the centre offset, so that both impulses act at one point of the world and angular momentum is conserved.
// Since w . (r x n) = r . (n x w), the normal speeds of all points follow from one vector and one number per manifold:
//     v_i = n . (vB - vA) + d . (n x wB)  +  r_i . (n x wB - n x wA),
// and so do the separations, from the normal rotated back with each body. The points of a manifold are solved as one
// dense problem: an impulse at one point changes the speed at another by their coupling, and the bodies receive the
// sum.

namespace rubble {

/// The passes before the sub-steps: finding outdated manifolds, and computing separations, approach speeds, effective
/// masses and the friction centre.
template <int W>
struct PrepareKernels : ContactLanes<W> {
    using Lanes = ContactLanes<W>;
    using F = typename Lanes::F;
    using V = typename Lanes::V;
    using Q = typename Lanes::Q;
    using Lanes::hasPoint;
    using Lanes::normalSpeed;
    using Lanes::poses;
    using Lanes::put;
    using Lanes::row;
    using Lanes::velocities;
    using typename Lanes::Poses;
    using typename Lanes::Velocities;

    static constexpr float kFrictionFalloffDistance =
        0.02f;  // m: separation beyond which points have no weight in the friction centre
    static constexpr float kMinWeight = 1e-10f;           // keeps the friction centre defined
    static constexpr float kMinRotationCosine = 0.9924f;  // squared cosine of half of ten degrees

    static unsigned staleLanes(const ContactBlock& block, const ReferenceBlock& reference, const SolverStep& step) {
        unsigned stale = 0;
        for (int part = 0; part < kBlockLanes / W; ++part) {
            const Poses a = poses(block.first, part, step), b = poses(block.second, part, step);
            const Q thenA = row(reference.firstRotation, part), thenB = row(reference.secondRotation, part);
            const Q rotationA = a.rotation * thenA.conjugate(), rotationB = b.rotation * thenB.conjugate();
            const V position = row(block.points[0].position, part), centreOffset = row(reference.centreOffset, part);
            const V slip =
                b.centre - a.centre + rotated<W>(rotationB, position + centreOffset) - rotated<W>(rotationA, position);
            // The relative rotation: for small angles, twice the vector part.
            const V relative = (rotationA.conjugate() * rotationB).vector();
            const F boundingRadius = lesser<W>(a.boundingRadius, b.boundingRadius);
            const F displacement =
                squareRoot<W>(dot<W>(slip, slip)) + 2.0f * boundingRadius * squareRoot<W>(dot<W>(relative, relative));
            const F cosine = lesser<W>(rotationA.w * rotationA.w, rotationB.w * rotationB.w);
            const auto isStale = (displacement > row(reference.slack, part)) | (cosine < all<W>(kMinRotationCosine));
            stale |= bitsOf<W>(isStale & hasPoint(block, part, 0)) << (part * W);
        }
        return stale;
    }

    /// Computes the current separations and approach speeds. Returns the least separations, of points that are not
    /// there as well.
    [[gnu::always_inline]] static F updatePoints(ContactBlock& block, const ReferenceBlock& reference, int part,
                                                 const Poses& a, const Poses& b, const Velocities& va,
                                                 const Velocities& vb) {
        const V n = row(block.normal, part), now = a.centre - b.centre, then = row(reference.centreOffset, part);
        // Impulses act where the bodies are now, or, for swept manifolds, at their time of impact.
        const auto isSwept = row(reference.isSwept, part) > F{};
        const V centreOffset{select<W>(isSwept, then.x, now.x), select<W>(isSwept, then.y, now.y),
                             select<W>(isSwept, then.z, now.z)};
        const V nA = rotated<W>((a.rotation * row(reference.firstRotation, part).conjugate()).conjugate(), n);
        const V nB = rotated<W>((b.rotation * row(reference.secondRotation, part).conjugate()).conjugate(), n);
        const F base = dot<W>(nB, then) - dot<W>(n, now);
        const V slope = nB - nA;
        const auto speed = normalSpeed(n, centreOffset, va, vb);
        put(centreOffset, block.centreOffset, part);
        for (FloatRow* sum : {&block.stepFrictionX, &block.stepFrictionY, &block.stepTorsionalImpulse}) {
            put(F{}, *sum, part);
        }
        put(all<W>(-1.0f), block.points[0].sustained, part);
        F least{};
        for (int i = 0; i < 4; ++i) {
            PointRows& point = block.points[i];
            const V position = row(point.position, part);
            const F separation = row(reference.separation[i], part) + base + dot<W>(position, slope);
            put(separation, point.separation, part);
            put(speed.at(position), point.approach, part);
            put(F{}, point.stepImpulse, part);
            least = lesser<W>(least, separation);
        }
        return least;
    }

    /// Computes the effective mass of each point along the normal, and the coupling of each pair.
    [[gnu::always_inline]] static void computeNormalMasses(ContactBlock& block, int part, const Poses& a,
                                                           const Poses& b, F inverseMass) {
        const V n = row(block.normal, part), centreOffset = row(block.centreOffset, part);
        V armA[4], armB[4], responseA[4], responseB[4];
        for (int i = 0; i < 4; ++i) {
            const V position = row(block.points[i].position, part);
            armA[i] = cross<W>(position, n);
            armB[i] = cross<W>(position + centreOffset, n);
            responseA[i] = a.inverseInertia * armA[i];
            responseB[i] = b.inverseInertia * armB[i];
        }
        int pair = 0;
        for (int i = 0; i < 4; ++i) {
            const F own = inverseMass + dot<W>(armA[i], responseA[i]) + dot<W>(armB[i], responseB[i]);
            put(select<W>(hasPoint(block, part, i), inverseOrZero<W>(own), F{}), block.points[i].effectiveMass, part);
            for (int j = i + 1; j < 4; ++j) {
                put(inverseMass + dot<W>(armA[i], responseA[j]) + dot<W>(armB[i], responseB[j]), block.coupling[pair++],
                    part);
            }
        }
    }

    [[gnu::always_inline]] static V frictionCentre(const ContactBlock& block, int part) {
        V centre{};
        F whole{};
        for (int i = 0; i < 4; ++i) {
            const PointRows& point = block.points[i];
            F weight = 2.0f - row(point.separation, part) * (1.0f / kFrictionFalloffDistance);
            weight = greater<W>(lesser<W>(weight, all<W>(1.0f)), all<W>(kMinWeight));
            weight = select<W>(hasPoint(block, part, i), weight, F{});
            centre = centre + row(point.position, part) * weight;
            whole = whole + weight;
        }
        return centre * inverseOrZero<W>(whole);
    }

    /// Computes the effective masses of friction at the friction centre and of torsional friction about the normal.
    [[gnu::always_inline]] static void computeFrictionMasses(ContactBlock& block, int part, const Poses& a,
                                                             const Poses& b, F inverseMass) {
        const V n = row(block.normal, part), centreOffset = row(block.centreOffset, part);
        const V tangent = row(block.tangent, part), other = cross<W>(n, tangent);
        const V centre = frictionCentre(block, part);
        put(centre, block.frictionCentre, part);
        for (int i = 0; i < 4; ++i) {
            const V lever = row(block.points[i].position, part) - centre;
            put(squareRoot<W>(dot<W>(lever, lever)), block.points[i].lever, part);
        }
        const V armA1 = cross<W>(centre, tangent), armA2 = cross<W>(centre, other);
        const V armB1 = cross<W>(centre + centreOffset, tangent), armB2 = cross<W>(centre + centreOffset, other);
        const V responseA2 = a.inverseInertia * armA2, responseB2 = b.inverseInertia * armB2;
        const F xx = inverseMass + dot<W>(armA1, a.inverseInertia * armA1) + dot<W>(armB1, b.inverseInertia * armB1);
        const F xy = dot<W>(armA1, responseA2) + dot<W>(armB1, responseB2);
        const F yy = inverseMass + dot<W>(armA2, responseA2) + dot<W>(armB2, responseB2);
        const F inverse = inverseOrZero<W>(xx * yy - xy * xy);
        put(yy * inverse, block.tangentMassXX, part);
        put(-xy * inverse, block.tangentMassXY, part);
        put(xx * inverse, block.tangentMassYY, part);
        put(inverseOrZero<W>(dot<W>(n, a.inverseInertia * n) + dot<W>(n, b.inverseInertia * n)), block.torsionalMass,
            part);
    }

    /// Empty lanes have bodies that are not dynamic.
    [[gnu::always_inline]] static Masks<W> differ(const Velocities& a, const Velocities& b) {
        const F heavier = lesser<W>(a.inverseMass, b.inverseMass), lighter = greater<W>(a.inverseMass, b.inverseMass);
        return (heavier > F{}) & (lighter > kMaxLoadRatio * heavier);
    }

    static BlockTraits prepare(std::span<ContactBlock> blocks, std::span<const ReferenceBlock> references,
                               const SolverStep& step) {
        Masks<W> massesDiffer{}, isDeep{};
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            ContactBlock& block = blocks[i];
            for (int part = 0; part < kBlockLanes / W; ++part) {
                const Poses a = poses(block.first, part, step), b = poses(block.second, part, step);
                const Velocities va = velocities(block.first, part, step), vb = velocities(block.second, part, step);
                put(a.inverseInertia, block.firstInverseInertia, part);
                put(b.inverseInertia, block.secondInverseInertia, part);
                put(F{}, block.sharedMassScale, part);
                const F least = updatePoints(block, references[i], part, a, b, va, vb);
                isDeep |= least * row(block.stiffening, part) < all<W>(-kDeepOverlap);
                computeNormalMasses(block, part, a, b, va.inverseMass + vb.inverseMass);
                computeFrictionMasses(block, part, a, b, va.inverseMass + vb.inverseMass);
                massesDiffer |= differ(va, vb);
            }
        }
        return {bitsOf<W>(massesDiffer) != 0, bitsOf<W>(isDeep) != 0};
    }
};

}  // namespace rubble
