#pragma once

#include "core/physics/LaneMath.h"
#include "core/physics/SolverKernels.h"

// The solver's passes for W lanes, instantiated by a file for each width, which is compiled for machines that have it.
//
// A contact's normal n points from the first body (A) to the second (B). A point of it is at r from A's centre and at r + d from
// B's, with d = apart, so that both impulses act at one place of the world and angular momentum is kept. With
// w . (r x n) = r . (n x w), the normal speeds of all points follow from one vector and one number a manifold:
//     v_i = n . (vB - vA) + d . (n x wB)  +  r_i . (n x wB - n x wA),
// and so do the separations, from the normal turned back with each body. The points of a manifold are one dense problem: an
// impulse at one changes the speed at another by their coupling, and bodies hear of the sum.

namespace rubble {

template <int W>
struct WideKernels {
    using F = Floats<W>;
    using V = WideVec3<W>;
    using Q = WideQuat<W>;

    static constexpr int kThrowRounds = 8;              // after one alone, a box that lands flat would spin
    static constexpr float kFrictionReach = 0.02f;      // m: points farther apart count less for the friction centre
    static constexpr float kLeastWeight = 1e-10f;       // so that some centre is always there
    static constexpr float kLeastTurnCosine = 0.9924f;  // squared, of half the angle: ten degrees

    // Rows to lanes.
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

    /// Columns of `Count` numbers that lie one after another in each of W places.
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
        V spin;
        F damping;
    };
    struct Motions : Velocities {
        V moved;
        Q turned;
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
    /// Writes velocities back, of dynamic bodies only: others may be in several lanes, and of several threads.
    [[gnu::always_inline]] static void putVelocities(const Velocities& v, const IndexRow& bodies, int part,
                                                     const SolverStep& step) {
        F c[8] = {v.linear.x, v.linear.y, v.linear.z, v.inverseMass, v.spin.x, v.spin.y, v.spin.z, v.damping};
        for (int chunk = 0; chunk < 8; chunk += W) transpose<W>(c + chunk);
        const unsigned dynamic = bitsOf<W>(v.inverseMass > F{});
        for (int lane = 0; lane < W; ++lane) {
            if ((dynamic >> lane & 1u) == 0) continue;
            float* to = &step.motions[bodies[part * W + lane]].velocity.x;
            for (int chunk = 0; chunk < 8; chunk += W) store<W>(c[chunk + lane], to + chunk);
        }
    }

    struct Places {
        V centre;
        Q turn;
        WideSym3<W> inverseInertia;
        F reach;
    };
    [[gnu::always_inline]] static Places places(const IndexRow& bodies, int part, const SolverStep& step) {
        const float* rows[W];
        for (int lane = 0; lane < W; ++lane) rows[lane] = &step.places[bodies[part * W + lane]].centre.x;
        F c[16];
        gather<16>(rows, c);
        return {{c[0], c[1], c[2]}, {c[4], c[5], c[6], c[7]}, {c[8], c[9], c[10], c[11], c[12], c[13]}, c[14]};
    }

    [[gnu::always_inline]] static int mostPoints(const ContactBlock& block, int part) {
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

    /// The impulses of a manifold, summed up: along n, and where.
    struct Push {
        F along{};
        V moment{};  // sum of impulse times place
    };
    [[gnu::always_inline]] static void apply(const Push& push, const V& n, const V& apart, const ContactBlock& block,
                                             int part, Velocities& a, Velocities& b) {
        const V impulse = n * push.along;
        a.linear = a.linear - impulse * a.inverseMass;
        b.linear = b.linear + impulse * b.inverseMass;
        a.spin = a.spin - row(block.firstInverseInertia, part) * cross<W>(push.moment, n);
        b.spin = b.spin + row(block.secondInverseInertia, part) * cross<W>(push.moment + apart * push.along, n);
    }
    /// An impulse at a place.
    [[gnu::always_inline]] static void applyAt(const V& impulse, const V& place, const V& apart,
                                               const ContactBlock& block, int part, Velocities& a, Velocities& b) {
        a.linear = a.linear - impulse * a.inverseMass;
        b.linear = b.linear + impulse * b.inverseMass;
        a.spin = a.spin - row(block.firstInverseInertia, part) * cross<W>(place, impulse);
        b.spin = b.spin + row(block.secondInverseInertia, part) * cross<W>(place + apart, impulse);
    }
    [[gnu::always_inline]] static void applyTwist(F twist, const V& n, const ContactBlock& block, int part,
                                                  Velocities& a, Velocities& b) {
        a.spin = a.spin - row(block.firstInverseInertia, part) * (n * twist);
        b.spin = b.spin + row(block.secondInverseInertia, part) * (n * twist);
    }

    static unsigned staleLanes(const ContactBlock& block, const ReferenceBlock& reference, const SolverStep& step) {
        unsigned stale = 0;
        for (int part = 0; part < kBlockLanes / W; ++part) {
            const Places a = places(block.first, part, step), b = places(block.second, part, step);
            const Q thenA = row(reference.firstTurn, part), thenB = row(reference.secondTurn, part);
            const Q turnA = a.turn * thenA.conjugate(), turnB = b.turn * thenB.conjugate();
            const V place = row(block.points[0].place, part), apart = row(reference.apart, part);
            const V slip = b.centre - a.centre + turned<W>(turnB, place + apart) - turned<W>(turnA, place);
            // How both turned against each other: of small angles, twice the vector part.
            const V turn = (turnA.conjugate() * turnB).vector();
            const F reach = lesser<W>(a.reach, b.reach);
            const F way = squareRoot<W>(dot<W>(slip, slip)) + 2.0f * reach * squareRoot<W>(dot<W>(turn, turn));
            const F cosine = lesser<W>(turnA.w * turnA.w, turnB.w * turnB.w);
            const auto moved = (way > row(reference.slack, part)) | (cosine < all<W>(kLeastTurnCosine));
            stale |= bitsOf<W>(moved & hasPoint(block, part, 0)) << (part * W);
        }
        return stale;
    }

    /// The separations now, and the speeds at which they change.
    [[gnu::always_inline]] static void placePoints(ContactBlock& block, const ReferenceBlock& reference, int part,
                                                   const Places& a, const Places& b, const Velocities& va,
                                                   const Velocities& vb) {
        const V n = row(block.normal, part), now = a.centre - b.centre, then = row(reference.apart, part);
        // Impulses act at one place of the world: where the bodies are, or, of fast ones, where they will be when they meet.
        const auto isSwept = row(reference.isSwept, part) > F{};
        const V apart{select<W>(isSwept, then.x, now.x), select<W>(isSwept, then.y, now.y),
                      select<W>(isSwept, then.z, now.z)};
        const V nA = turned<W>((a.turn * row(reference.firstTurn, part).conjugate()).conjugate(), n);
        const V nB = turned<W>((b.turn * row(reference.secondTurn, part).conjugate()).conjugate(), n);
        const F base = dot<W>(nB, then) - dot<W>(n, now);
        const V slope = nB - nA, spinA = cross<W>(n, va.spin), spinB = cross<W>(n, vb.spin);
        const F speed = dot<W>(n, vb.linear - va.linear) + dot<W>(apart, spinB);
        const V speedSlope = spinB - spinA;
        put(apart, block.apart, part);
        for (int i = 0; i < 4; ++i) {
            PointRows& point = block.points[i];
            const V place = row(point.place, part);
            put(row(reference.separation[i], part) + base + dot<W>(place, slope), point.separation, part);
            put(speed + dot<W>(place, speedSlope), point.approach, part);
            put(F{}, point.stepImpulse, part);
        }
    }

    /// How the points of a manifold answer to impulses along the normal.
    [[gnu::always_inline]] static void coupleNormals(ContactBlock& block, int part, const Places& a, const Places& b,
                                                     F inverseMass) {
        const V n = row(block.normal, part), apart = row(block.apart, part);
        V armA[4], armB[4], answerA[4], answerB[4];
        for (int i = 0; i < 4; ++i) {
            const V place = row(block.points[i].place, part);
            armA[i] = cross<W>(place, n);
            armB[i] = cross<W>(place + apart, n);
            answerA[i] = a.inverseInertia * armA[i];
            answerB[i] = b.inverseInertia * armB[i];
        }
        int pair = 0;
        for (int i = 0; i < 4; ++i) {
            const F own = inverseMass + dot<W>(armA[i], answerA[i]) + dot<W>(armB[i], answerB[i]);
            put(select<W>(hasPoint(block, part, i), inverseOrZero<W>(own), F{}), block.points[i].effectiveMass, part);
            for (int j = i + 1; j < 4; ++j) {
                put(inverseMass + dot<W>(armA[i], answerA[j]) + dot<W>(armB[i], answerB[j]), block.coupling[pair++],
                    part);
            }
        }
    }

    [[gnu::always_inline]] static V frictionCentre(const ContactBlock& block, int part) {
        V centre{};
        F whole{};
        for (int i = 0; i < 4; ++i) {
            const PointRows& point = block.points[i];
            F weight = 2.0f - row(point.separation, part) * (1.0f / kFrictionReach);
            weight = greater<W>(lesser<W>(weight, all<W>(1.0f)), all<W>(kLeastWeight));
            weight = select<W>(hasPoint(block, part, i), weight, F{});
            centre = centre + row(point.place, part) * weight;
            whole = whole + weight;
        }
        return centre * inverseOrZero<W>(whole);
    }

    /// How a manifold answers to friction at its centre, and to a twist about its normal.
    [[gnu::always_inline]] static void coupleFriction(ContactBlock& block, int part, const Places& a, const Places& b,
                                                      F inverseMass) {
        const V n = row(block.normal, part), apart = row(block.apart, part);
        const V tangent = row(block.tangent, part), other = cross<W>(n, tangent);
        const V centre = frictionCentre(block, part);
        put(centre, block.frictionCentre, part);
        for (int i = 0; i < 4; ++i) {
            const V lever = row(block.points[i].place, part) - centre;
            put(squareRoot<W>(dot<W>(lever, lever)), block.points[i].lever, part);
        }
        const V armA1 = cross<W>(centre, tangent), armA2 = cross<W>(centre, other);
        const V armB1 = cross<W>(centre + apart, tangent), armB2 = cross<W>(centre + apart, other);
        const V answerA2 = a.inverseInertia * armA2, answerB2 = b.inverseInertia * armB2;
        const F xx = inverseMass + dot<W>(armA1, a.inverseInertia * armA1) + dot<W>(armB1, b.inverseInertia * armB1);
        const F xy = dot<W>(armA1, answerA2) + dot<W>(armB1, answerB2);
        const F yy = inverseMass + dot<W>(armA2, answerA2) + dot<W>(armB2, answerB2);
        const F inverse = inverseOrZero<W>(xx * yy - xy * xy);
        put(yy * inverse, block.tangentMassXX, part);
        put(-xy * inverse, block.tangentMassXY, part);
        put(xx * inverse, block.tangentMassYY, part);
        put(inverseOrZero<W>(dot<W>(n, a.inverseInertia * n) + dot<W>(n, b.inverseInertia * n)), block.twistMass, part);
    }

    static void prepare(std::span<ContactBlock> blocks, std::span<const ReferenceBlock> references,
                        const SolverStep& step) {
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            ContactBlock& block = blocks[i];
            for (int part = 0; part < kBlockLanes / W; ++part) {
                const Places a = places(block.first, part, step), b = places(block.second, part, step);
                const Velocities va = velocities(block.first, part, step), vb = velocities(block.second, part, step);
                put(a.inverseInertia, block.firstInverseInertia, part);
                put(b.inverseInertia, block.secondInverseInertia, part);
                placePoints(block, references[i], part, a, b, va, vb);
                coupleNormals(block, part, a, b, va.inverseMass + vb.inverseMass);
                coupleFriction(block, part, a, b, va.inverseMass + vb.inverseMass);
            }
        }
    }

    static void warmStart(std::span<ContactBlock> blocks, const SolverStep& step) {
        for (ContactBlock& block : blocks) {
            for (int part = 0; part < kBlockLanes / W; ++part) {
                const int points = mostPoints(block, part);
                if (points == 0) continue;
                Velocities a = velocities(block.first, part, step), b = velocities(block.second, part, step);
                const V n = row(block.normal, part), apart = row(block.apart, part), t = row(block.tangent, part);
                Push push;
                for (int i = 0; i < points; ++i) {
                    const F impulse = row(block.points[i].impulse, part);
                    push.along = push.along + impulse;
                    push.moment = push.moment + row(block.points[i].place, part) * impulse;
                }
                apply(push, n, apart, block, part, a, b);
                const V friction = t * row(block.frictionX, part) + cross<W>(n, t) * row(block.frictionY, part);
                applyAt(friction, row(block.frictionCentre, part), apart, block, part, a, b);
                applyTwist(row(block.twist, part), n, block, part, a, b);
                putVelocities(a, block.first, part, step);
                putVelocities(b, block.second, part, step);
            }
        }
    }

    /// What the normal impulses of a manifold came to.
    struct Load {
        F along{};     // N s
        F leverage{};  // N m s: what resists a twist, by one of friction
    };

    template <bool kWithBias>
    [[gnu::always_inline]] static Load pushNormals(ContactBlock& block, int part, int points, const SolverStep& step,
                                                   const Motions& from, Velocities& a, const Motions& to,
                                                   Velocities& b) {
        const V n = row(block.normal, part), apart = row(block.apart, part);
        const V nA = turned<W>(from.turned.conjugate(), n) - n, nB = turned<W>(to.turned.conjugate(), n) - n;
        const F moved = dot<W>(n, to.moved - from.moved) + dot<W>(apart, nB);
        const V movedSlope = nB - nA;
        const V spinA = cross<W>(n, a.spin), spinB = cross<W>(n, b.spin), speedSlope = spinB - spinA;
        const F speed = dot<W>(n, b.linear - a.linear) + dot<W>(apart, spinB);

        F biasRate{}, massScale = all<W>(1.0f), impulseScale{};
        if constexpr (kWithBias) {
            const auto fixed = row(block.againstFixed, part) > F{};
            const Softness &hard = step.againstFixed, &soft = step.betweenBodies;
            massScale = select<W>(fixed, all<W>(hard.massScale), all<W>(soft.massScale));
            biasRate = select<W>(fixed, all<W>(hard.biasRate), all<W>(soft.biasRate)) * massScale;
            impulseScale = select<W>(fixed, all<W>(hard.impulseScale), all<W>(soft.impulseScale));
        }
        const F perSubStep = all<W>(1.0f / step.subStep);
        F normalSpeed[4];
        for (int i = 0; i < points; ++i) normalSpeed[i] = speed + dot<W>(row(block.points[i].place, part), speedSlope);

        Load load;
        Push push;
        for (int i = 0; i < points; ++i) {
            PointRows& point = block.points[i];
            const V place = row(point.place, part);
            const F mass = row(point.effectiveMass, part), before = row(point.impulse, part);
            const F separation = row(point.separation, part) + moved + dot<W>(place, movedSlope);
            F back;  // the speed to take away, as momentum
            if constexpr (kWithBias) {
                const auto open = separation > F{};
                const F bias = select<W>(open, separation * perSubStep,
                                         greater<W>(biasRate * separation, all<W>(-step.pushOutSpeed)));
                back = mass * (select<W>(open, all<W>(1.0f), massScale) * normalSpeed[i] + bias) +
                       select<W>(open, F{}, impulseScale) * before;
            } else {
                // A point that neither touches nor pushes waits for the next sub-step: it must not be slowed down before, or
                // the impact that the next step measures would be less.
                const auto waits = (separation > F{}) & (before <= F{});
                const F slowed = mass * (normalSpeed[i] + greater<W>(separation, F{}) * perSubStep);
                back = select<W>(waits, F{}, slowed);
            }
            const F after = greater<W>(before - back, F{}), change = after - before;
            put(after, point.impulse, part);
            push.along = push.along + change;
            push.moment = push.moment + place * change;
            for (int j = i + 1; j < points; ++j) {
                normalSpeed[j] = normalSpeed[j] + row(block.coupling[coupled(i, j)], part) * change;
            }
            if constexpr (!kWithBias) {
                put(row(point.stepImpulse, part) + after, point.stepImpulse, part);
                load.along = load.along + after;
                load.leverage = load.leverage + row(point.lever, part) * after;
            }
        }
        apply(push, n, apart, block, part, a, b);
        return load;
    }

    /// The number of a pair of points in ContactBlock::coupling.
    static constexpr int coupled(int i, int j) { return i == 0 ? j - 1 : i + j; }

    [[gnu::always_inline]] static void pushTangents(ContactBlock& block, int part, const Load& load, Velocities& a,
                                                    Velocities& b) {
        const V n = row(block.normal, part), apart = row(block.apart, part), centre = row(block.frictionCentre, part);
        const V tangent = row(block.tangent, part), other = cross<W>(n, tangent);
        const F friction = row(block.friction, part);

        const F twistBefore = row(block.twist, part), mostTwist = friction * load.leverage;
        F twist = twistBefore - row(block.twistMass, part) * dot<W>(n, b.spin - a.spin);
        twist = greater<W>(lesser<W>(twist, mostTwist), -mostTwist);
        put(twist, block.twist, part);
        applyTwist(twist - twistBefore, n, block, part, a, b);

        const V slip = b.linear + cross<W>(b.spin, centre + apart) - a.linear - cross<W>(a.spin, centre);
        const F slipX = dot<W>(slip, tangent), slipY = dot<W>(slip, other);
        const F xx = row(block.tangentMassXX, part), xy = row(block.tangentMassXY, part),
                yy = row(block.tangentMassYY, part);
        const F beforeX = row(block.frictionX, part), beforeY = row(block.frictionY, part);
        F x = beforeX - (xx * slipX + xy * slipY), y = beforeY - (xy * slipX + yy * slipY);
        const F most = friction * load.along, size = x * x + y * y;
        const auto slides = size > most * most;
        const F scale = select<W>(slides, most / squareRoot<W>(select<W>(slides, size, all<W>(1.0f))), all<W>(1.0f));
        x = x * scale;
        y = y * scale;
        put(x, block.frictionX, part);
        put(y, block.frictionY, part);
        applyAt(tangent * (x - beforeX) + other * (y - beforeY), centre, apart, block, part, a, b);
    }

    template <bool kWithBias>
    static void pass(std::span<ContactBlock> blocks, const SolverStep& step) {
        for (ContactBlock& block : blocks) {
            for (int part = 0; part < kBlockLanes / W; ++part) {
                const int points = mostPoints(block, part);
                if (points == 0) continue;
                const Motions from = motions(block.first, part, step), to = motions(block.second, part, step);
                Velocities a = from, b = to;
                const Load load = pushNormals<kWithBias>(block, part, points, step, from, a, to, b);
                if constexpr (!kWithBias) pushTangents(block, part, load, a, b);
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
                const int points = mostPoints(block, part);
                if (points == 0 || bitsOf<W>(restitution > F{}) == 0) continue;
                Velocities a = velocities(block.first, part, step), b = velocities(block.second, part, step);
                throwBack(block, part, points, restitution, step, a, b);
                putVelocities(a, block.first, part, step);
                putVelocities(b, block.second, part, step);
            }
        }
    }

    [[gnu::always_inline]] static void throwBack(ContactBlock& block, int part, int points, F restitution,
                                                 const SolverStep& step, Velocities& a, Velocities& b) {
        const V n = row(block.normal, part), apart = row(block.apart, part);
        for (int round = 0; round < kThrowRounds * points; ++round) {
            const int i = round % points;
            PointRows& point = block.points[i];
            const V place = row(point.place, part);
            const F came = row(point.approach, part), stepImpulse = row(point.stepImpulse, part);
            // What only came near was not hit.
            const auto hit = (came < all<W>(-step.restitutionSpeed)) & (stepImpulse > F{}) & (restitution > F{});
            const V spinA = cross<W>(n, a.spin), spinB = cross<W>(n, b.spin);
            const F speed = dot<W>(n, b.linear - a.linear) + dot<W>(apart, spinB) + dot<W>(place, spinB - spinA);
            const F before = row(point.impulse, part);
            F after = greater<W>(before - row(point.effectiveMass, part) * (speed + restitution * came), F{});
            after = select<W>(hit, after, before);
            const F change = after - before;
            put(after, point.impulse, part);
            put(stepImpulse + change, point.stepImpulse, part);
            apply({change, place * change}, n, apart, block, part, a, b);
        }
    }

    static void integrateVelocities(std::span<const std::uint32_t> bodies, const SolverStep& step) {
        const float h = step.subStep;
        for (std::uint32_t body : bodies) {
            BodyMotion& motion = step.motions[body];
            if (motion.inverseMass == 0.0f) continue;
            const float linear = 1.0f / (1.0f + h * motion.linearDamping),
                        angular = 1.0f / (1.0f + h * motion.angularDamping);
            motion.velocity.x = (motion.velocity.x + h * step.gravity.x) * linear;
            motion.velocity.y = (motion.velocity.y + h * step.gravity.y) * linear;
            motion.velocity.z = (motion.velocity.z + h * step.gravity.z) * linear;
            motion.spin.x *= angular;
            motion.spin.y *= angular;
            motion.spin.z *= angular;
        }
    }

    static void integratePositions(std::span<const std::uint32_t> bodies, const SolverStep& step) {
        const F h = all<W>(step.subStep), half = all<W>(0.5f * step.subStep);
        for (std::size_t first = 0; first < bodies.size(); first += W) {
            const int count = bodies.size() - first < W ? static_cast<int>(bodies.size() - first) : W;
            IndexRow index{};
            for (int lane = 0; lane < count; ++lane) index[lane] = bodies[first + lane];
            const Motions m = motions(index, 0, step);
            const V moved = m.moved + m.linear * h;
            const V turn = m.spin * half;
            const Q& q = m.turned;
            Q next{q.x + turn.x * q.w + turn.y * q.z - turn.z * q.y, q.y - turn.x * q.z + turn.y * q.w + turn.z * q.x,
                   q.z + turn.x * q.y - turn.y * q.x + turn.z * q.w, q.w - turn.x * q.x - turn.y * q.y - turn.z * q.z};
            const F scale = 1.0f / squareRoot<W>(next.x * next.x + next.y * next.y + next.z * next.z + next.w * next.w);
            F angularDamping{};
            for (int lane = 0; lane < count; ++lane) angularDamping[lane] = step.motions[index[lane]].angularDamping;
            F c[8] = {moved.x,        moved.y,        moved.z,        angularDamping,
                      next.x * scale, next.y * scale, next.z * scale, next.w * scale};
            for (int chunk = 0; chunk < 8; chunk += W) transpose<W>(c + chunk);
            for (int lane = 0; lane < count; ++lane) {
                float* to = &step.motions[index[lane]].moved.x;
                for (int chunk = 0; chunk < 8; chunk += W) store<W>(c[chunk + lane], to + chunk);
            }
        }
    }

    static constexpr SolverKernels kTable{&staleLanes, &prepare,   &warmStart,           &solve,
                                          &relax,      &restitute, &integrateVelocities, &integratePositions};
};

}  // namespace rubble
