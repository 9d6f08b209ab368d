#pragma once

#include "core/physics/math/LaneMath.h"
#include "core/physics/solver/SolverKernels.h"

namespace rubble {

/// W lanes of a contact block and of its bodies: loading, storing and applying impulses. Part `part` of a block is its
/// lanes [part * W, (part + 1) * W).
template <int W>
struct ContactLanes {
    using F = Floats<W>;
    using V = WideVec3<W>;
    using Q = WideQuat<W>;

    // Reading and writing W lanes of a row.
    [[gnu::always_inline]] static F row(const FloatRow& values, int part) {
        return loaded<W>(values.data() + part * W);
    }
    [[gnu::always_inline]] static V row(const Vec3Row& values, int part) {
        return {row(values.x, part), row(values.y, part), row(values.z, part)};
    }
    [[gnu::always_inline]] static Q row(const QuatRow& values, int part) {
        return {row(values.x, part), row(values.y, part), row(values.z, part), row(values.w, part)};
    }
    [[gnu::always_inline]] static WideSym3<W> row(const SymMat3Row& m, int part) {
        return {row(m.xx, part), row(m.xy, part), row(m.xz, part), row(m.yy, part), row(m.yz, part), row(m.zz, part)};
    }
    [[gnu::always_inline]] static void put(F value, FloatRow& values, int part) {
        store<W>(value, values.data() + part * W);
    }
    [[gnu::always_inline]] static void put(const V& value, Vec3Row& values, int part) {
        put(value.x, values.x, part);
        put(value.y, values.y, part);
        put(value.z, values.z, part);
    }
    [[gnu::always_inline]] static void put(const WideSym3<W>& m, SymMat3Row& values, int part) {
        put(m.xx, values.xx, part);
        put(m.xy, values.xy, part);
        put(m.xz, values.xz, part);
        put(m.yy, values.yy, part);
        put(m.yz, values.yz, part);
        put(m.zz, values.zz, part);
    }

    /// Loads `Count` consecutive floats from each of W addresses, transposed: column i holds the i-th of each.
    template <int Count>
    [[gnu::always_inline]] static void gather(const float* const* from, F* columns) {
        static_assert(Count % W == 0);
        for (int chunk = 0; chunk < Count; chunk += W) {
            for (int lane = 0; lane < W; ++lane) columns[chunk + lane] = loaded<W>(from[lane] + chunk);
            transpose<W>(columns + chunk);
        }
    }

    struct Velocities {
        V linear;
        F inverseMass;
        V angularVelocity;
        F damping;
    };
    struct Motions : Velocities {
        V deltaPosition;
        Q deltaRotation;
    };

    [[gnu::always_inline]] static void motionRows(const IndexRow& bodies, int part, const SolverStep& step,
                                                  const float** rows) {
        for (int lane = 0; lane < W; ++lane) rows[lane] = &step.motions[bodies[part * W + lane]].velocity.x;
    }
    [[gnu::always_inline]] static Velocities velocities(const IndexRow& bodies, int part, const SolverStep& step) {
        const float* rows[W];
        motionRows(bodies, part, step, rows);
        F c[8];
        gather<8>(rows, c);
        return {{c[0], c[1], c[2]}, c[3], {c[4], c[5], c[6]}, c[7]};
    }
    [[gnu::always_inline]] static Motions motions(const IndexRow& bodies, int part, const SolverStep& step) {
        const float* rows[W];
        motionRows(bodies, part, step, rows);
        F c[16];
        gather<16>(rows, c);
        return {
            {{c[0], c[1], c[2]}, c[3], {c[4], c[5], c[6]}, c[7]}, {c[8], c[9], c[10]}, {c[12], c[13], c[14], c[15]}};
    }
    /// Writes back the velocities of dynamic bodies only: other bodies may be in several lanes and on several threads.
    [[gnu::always_inline]] static void putVelocities(const Velocities& v, const IndexRow& bodies, int part,
                                                     const SolverStep& step) {
        F c[8] = {v.linear.x,          v.linear.y,          v.linear.z,          v.inverseMass,
                  v.angularVelocity.x, v.angularVelocity.y, v.angularVelocity.z, v.damping};
        for (int chunk = 0; chunk < 8; chunk += W) transpose<W>(c + chunk);
        const unsigned dynamic = bitsOf<W>(v.inverseMass > F{});
        for (int lane = 0; lane < W; ++lane) {
            if ((dynamic >> lane & 1u) == 0) continue;
            float* to = &step.motions[bodies[part * W + lane]].velocity.x;
            for (int chunk = 0; chunk < 8; chunk += W) store<W>(c[chunk + lane], to + chunk);
        }
    }

    struct Poses {
        V centre;
        Q rotation;
        WideSym3<W> inverseInertia;
        F boundingRadius;
    };
    [[gnu::always_inline]] static Poses poses(const IndexRow& bodies, int part, const SolverStep& step) {
        const float* rows[W];
        for (int lane = 0; lane < W; ++lane) rows[lane] = &step.poses[bodies[part * W + lane]].centre.x;
        F c[16];
        gather<16>(rows, c);
        return {{c[0], c[1], c[2]}, {c[4], c[5], c[6], c[7]}, {c[8], c[9], c[10], c[11], c[12], c[13]}, c[14]};
    }

    [[gnu::always_inline]] static int maxPointCount(const ContactBlock& block, int part) {
        std::uint32_t most = 0;
        for (int lane = 0; lane < W; ++lane) {
            const std::uint32_t count = block.pointCount[part * W + lane];
            most = count > most ? count : most;
        }
        return static_cast<int>(most);
    }
    [[gnu::always_inline]] static Masks<W> hasPoint(const ContactBlock& block, int part, int point) {
        Masks<W> mask{};
        for (int lane = 0; lane < W; ++lane) {
            mask[lane] = block.pointCount[part * W + lane] > static_cast<std::uint32_t>(point) ? -1 : 0;
        }
        return mask;
    }

    /// The speeds of a manifold's points along its normal, m/s, negative where they approach; PrepareKernels.h derives
    /// them.
    struct NormalSpeed {
        F base;
        V slope;
        F at(const V& position) const { return base + dot<W>(position, slope); }
    };
    [[gnu::always_inline]] static NormalSpeed normalSpeed(const V& n, const V& centreOffset, const Velocities& a,
                                                          const Velocities& b) {
        const V spinA = cross<W>(n, a.angularVelocity), spinB = cross<W>(n, b.angularVelocity);
        return {dot<W>(n, b.linear - a.linear) + dot<W>(centreOffset, spinB), spinB - spinA};
    }

    /// The sum of a manifold's normal impulses.
    struct NormalImpulse {
        F sum{};     // N·s along n
        V moment{};  // N·m·s: sum of impulse times position
    };
    [[gnu::always_inline]] static void apply(const NormalImpulse& impulses, const V& n, const V& centreOffset,
                                             const ContactBlock& block, int part, Velocities& a, Velocities& b) {
        const V impulse = n * impulses.sum;
        a.linear = a.linear - impulse * a.inverseMass;
        b.linear = b.linear + impulse * b.inverseMass;
        a.angularVelocity = a.angularVelocity - row(block.firstInverseInertia, part) * cross<W>(impulses.moment, n);
        b.angularVelocity = b.angularVelocity + row(block.secondInverseInertia, part) *
                                                    cross<W>(impulses.moment + centreOffset * impulses.sum, n);
    }
    /// Applies an impulse at a position relative to the first body.
    [[gnu::always_inline]] static void applyAt(const V& impulse, const V& position, const V& centreOffset,
                                               const ContactBlock& block, int part, Velocities& a, Velocities& b) {
        a.linear = a.linear - impulse * a.inverseMass;
        b.linear = b.linear + impulse * b.inverseMass;
        a.angularVelocity = a.angularVelocity - row(block.firstInverseInertia, part) * cross<W>(position, impulse);
        b.angularVelocity =
            b.angularVelocity + row(block.secondInverseInertia, part) * cross<W>(position + centreOffset, impulse);
    }
    [[gnu::always_inline]] static void applyTorsionalImpulse(F torsional, const V& n, const ContactBlock& block,
                                                             int part, Velocities& a, Velocities& b) {
        a.angularVelocity = a.angularVelocity - row(block.firstInverseInertia, part) * (n * torsional);
        b.angularVelocity = b.angularVelocity + row(block.secondInverseInertia, part) * (n * torsional);
    }
};

}  // namespace rubble
