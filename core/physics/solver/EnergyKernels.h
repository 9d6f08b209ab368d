#pragma once

#include "core/physics/solver/ContactLanes.h"

namespace rubble {

/// What a step did to the energies of bodies.
template <int W>
struct EnergyKernels : ContactLanes<W> {
    using Lanes = ContactLanes<W>;
    using F = typename Lanes::F;
    using V = typename Lanes::V;
    using Lanes::motions;
    using typename Lanes::Motions;

    static void findLosses(std::span<const std::uint32_t> bodies, const SolverStep& step, const StartMotion* starts,
                           BodyLoss* losses) {
        const V gravity{all<W>(step.gravity.x), all<W>(step.gravity.y), all<W>(step.gravity.z)};
        for (std::size_t first = 0; first < bodies.size(); first += W) {
            const int count = bodies.size() - first < W ? static_cast<int>(bodies.size() - first) : W;
            IndexRow index{};
            for (int lane = 0; lane < count; ++lane) index[lane] = bodies[first + lane];
            const Motions now = motions(index, 0, step);
            const float* rows[W];
            for (int lane = 0; lane < W; ++lane) rows[lane] = &starts[index[lane]].velocity.x;
            F start[8], inertia[8];
            Lanes::template gather<8>(rows, start);
            for (int lane = 0; lane < W; ++lane) rows[lane] = &step.poses[index[lane]].inverseInertia.xx;
            Lanes::template gather<8>(rows, inertia);
            const V velocity{start[0], start[1], start[2]}, angularVelocity{start[4], start[5], start[6]};
            const V change = now.linear - velocity, turn = now.angularVelocity - angularVelocity;
            // Sums of products of changes and means: as a difference of energies, little of what is lost would be left.
            const F kinetic = all<W>(0.5f) * dot<W>(change, now.linear + velocity) - dot<W>(gravity, now.deltaPosition);
            const F spin =
                all<W>(0.5f) *
                dot<W>(angularMomentum({inertia[0], inertia[1], inertia[2], inertia[3], inertia[4], inertia[5]}, turn),
                       now.angularVelocity + angularVelocity);
            const F energy = -kinetic * inverseOrZero<W>(now.inverseMass) - spin;
            const unsigned far = bitsOf<W>(isFarFromFree(now, change - gravity * all<W>(step.dt)));
            for (int lane = 0; lane < count; ++lane) {
                const bool isDynamic = now.inverseMass[lane] > 0.0f;
                losses[index[lane]] = {isDynamic ? energy[lane] : 0.0f, isDynamic && (far >> lane & 1u) == 0};
            }
        }
    }

private:
    /// Whether velocities without damping are so far from those of free flight that they need no exact comparison.
    [[gnu::always_inline]] static Masks<W> isFarFromFree(const Motions& now, const V& difference) {
        constexpr float kFar = 1e-3f;  // of the speed, or m/s below 1 m/s: more than rounding
        const F limit = all<W>(kFar * kFar) * (all<W>(1.0f) + dot<W>(now.linear, now.linear));
        return (dot<W>(difference, difference) > limit) & (now.damping == F{});
    }

    /// The angular momentum of an angular velocity, from the inverse of the inertia: by its cofactors, as parts of its
    /// trace so that no product of three leaves the range of numbers.
    [[gnu::always_inline]] static V angularMomentum(const WideSym3<W>& inverse, const V& velocity) {
        const F scale = inverseOrZero<W>(inverse.xx + inverse.yy + inverse.zz);
        const WideSym3<W> m{inverse.xx * scale, inverse.xy * scale, inverse.xz * scale,
                            inverse.yy * scale, inverse.yz * scale, inverse.zz * scale};
        const WideSym3<W> cofactors{m.yy * m.zz - m.yz * m.yz, m.xz * m.yz - m.xy * m.zz, m.xy * m.yz - m.xz * m.yy,
                                    m.xx * m.zz - m.xz * m.xz, m.xy * m.xz - m.xx * m.yz, m.xx * m.yy - m.xy * m.xy};
        const F determinant = m.xx * cofactors.xx + m.xy * cofactors.xy + m.xz * cofactors.xz;
        return cofactors * velocity * (scale * inverseOrZero<W>(determinant));
    }
};

}  // namespace rubble
