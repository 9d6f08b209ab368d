#pragma once

#include "core/base/Random.h"
#include "core/physics/solver/SolverKernels.h"
#include "tests/support/geometry/Hulls.h"

#include <array>
#include <vector>

namespace rubble::test {

// Points of OneContact, m: under the centre of the cube, where the effective mass is that of the cube, 2 kg; one on
// either side of it; the corners.
inline const Vec3f kUnderCentre(0.0f, 0.0f, 0.0f);
inline const std::vector<Vec3f> kTwoPoints{{-0.25f, 0.0f, 0.0f}, {0.25f, 0.0f, 0.0f}};
inline const std::vector<Vec3f> kFourCorners{
    {-0.5f, 0.0f, -0.5f}, {0.5f, 0.0f, -0.5f}, {0.5f, 0.0f, 0.5f}, {-0.5f, 0.0f, 0.5f}};

/// A contact for the solver's kernels, in lane 0 of a block, with numbers to calculate by hand: a cube of 2 kg and 1 m
/// with a moment of inertia of 1/3 kg·m² stands on the ground, which is fixed. Its centre is 0.5 m above the origin,
/// which is the centre of the ground, and the normal is y.
struct OneContact {
    static constexpr std::uint32_t kGround = 1, kCube = 2;

    std::array<BodyMotion, 3> motions;
    std::array<BodyPose, 3> poses;
    ContactBlock block{};
    ReferenceBlock reference{};
    SolverStep step;

    /// A contact with points at these positions, m, from the origin.
    explicit OneContact(const std::vector<Vec3f>& points) {
        motions[kCube].inverseMass = 0.5f;
        poses[kCube].centre = Vec3f(0.0f, 0.5f, 0.0f);
        poses[kCube].inverseInertia = {3.0f, 0.0f, 0.0f, 3.0f, 0.0f, 3.0f};
        poses[kCube].boundingRadius = 1.0f;
        poses[kGround].boundingRadius = 100.0f;
        block.first[0] = kGround;
        block.second[0] = kCube;
        block.againstFixed[0] = 1.0f;
        block.normal.y[0] = block.tangent.x[0] = 1.0f;
        block.friction[0] = 0.5f;
        block.pointCount[0] = static_cast<std::uint32_t>(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            block.points[i].position.x[0] = points[i].x;
            block.points[i].position.y[0] = points[i].y;
            block.points[i].position.z[0] = points[i].z;
        }
        reference.centreOffset.y[0] = -0.5f;
        for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
            reference.firstRotation.w[lane] = reference.secondRotation.w[lane] = 1.0f;
        }
        reference.slack[0] = 0.01f;
        step.dt = 1.0f / 64.0f;
        step.subStep = 1.0f / 256.0f;
        step.againstFixed = {.biasRate = 32.0f, .massScale = 0.75f, .impulseScale = 0.25f};
        step.betweenBodies = {.biasRate = 16.0f, .massScale = 0.5f, .impulseScale = 0.5f};
        step.pushOutSpeed = 3.0f;
        step.restitutionSpeed = 1.0f;
    }

    BodyMotion& cube() { return motions[kCube]; }
    float& separation(std::size_t point) { return block.points[point].separation[0]; }
    float& impulse(std::size_t point) { return block.points[point].impulse[0]; }
    float& approach(std::size_t point) { return block.points[point].approach[0]; }
    float& stepImpulse(std::size_t point) { return block.points[point].stepImpulse[0]; }

    using Pass = void (*)(std::span<ContactBlock>, const SolverStep&);
    void apply(Pass pass) {
        step.motions = motions.data();
        step.poses = poses.data();
        pass({&block, 1}, step);
    }
    /// Computes separations, effective masses and the friction centre, then sets the separations to `separation`.
    void prepare(const SolverKernels& kernels, float separation) {
        prepare(kernels);
        for (PointRows& point : block.points) point.separation[0] = separation;
    }
    void prepare(const SolverKernels& kernels) {
        step.motions = motions.data();
        step.poses = poses.data();
        kernels.prepare({&block, 1}, {&reference, 1}, step);
    }
};

/// Eight contacts of sixteen bodies, with random poses, velocities, points and impulses.
struct RandomContacts {
    std::array<BodyMotion, 17> motions;
    std::array<BodyPose, 17> poses;
    ContactBlock block{};
    ReferenceBlock reference{};
    SolverStep step = OneContact({}).step;

    explicit RandomContacts(Random& random) {
        for (std::uint32_t body = 1; body < motions.size(); ++body) addBody(random, body);
        for (std::uint32_t lane = 0; lane < kBlockLanes; ++lane) addContact(random, lane);
        step.gravity = Vec3f(0.0f, -9.81f, 0.0f);
    }
    void prepare(const SolverKernels& kernels) {
        step.motions = motions.data();
        step.poses = poses.data();
        kernels.prepare({&block, 1}, {&reference, 1}, step);
    }

private:
    static float between(Random& random, double low, double high) {
        return static_cast<float>(random.between(low, high));
    }
    static Vec3f vector(Random& random, double half) { return toFloat(randomIn(random, half)); }

    void addBody(Random& random, std::uint32_t body) {
        const bool isFixed = random.below(5) == 0;
        BodyMotion& motion = motions[body];
        motion.velocity = vector(random, 2.0);
        motion.angularVelocity = vector(random, 2.0);
        motion.inverseMass = isFixed ? 0.0f : between(random, 0.1, 2.0);
        motion.linearDamping = between(random, 0.0, 0.5);
        motion.angularDamping = between(random, 0.0, 0.5);
        BodyPose& pose = poses[body];
        pose.centre = vector(random, 1.0);
        pose.rotation = toFloat(randomRotation(random));
        const float inverse = isFixed ? 0.0f : between(random, 1.0, 5.0);
        pose.inverseInertia = {inverse, 0.1f * inverse, 0.0f, 2.0f * inverse, -0.1f * inverse, inverse};
        pose.boundingRadius = 1.0f;
    }
    void addContact(Random& random, std::uint32_t lane) {
        block.pointCount[lane] = static_cast<std::uint32_t>(random.below(5));
        if (block.pointCount[lane] == 0) return;  // an empty lane
        block.first[lane] = 2 * lane + 1;
        block.second[lane] = 2 * lane + 2;
        const bool isFixed = motions[2 * lane + 1].inverseMass == 0.0f || motions[2 * lane + 2].inverseMass == 0.0f;
        block.againstFixed[lane] = isFixed ? 1.0f : 0.0f;
        const Vec3f normal = normalized(vector(random, 1.0)), tangent = normalized(cross(normal, vector(random, 1.0)));
        set(block.normal, lane, normal);
        set(block.tangent, lane, tangent);
        block.friction[lane] = between(random, 0.1, 1.0);
        block.restitution[lane] = random.below(2) == 0 ? 0.0f : between(random, 0.1, 1.0);
        block.stiffening[lane] = between(random, 20.0, 100.0);
        for (std::size_t i = 0; i < block.pointCount[lane]; ++i) {
            set(block.points[i].position, lane, vector(random, 0.5));
            block.points[i].impulse[lane] = between(random, 0.0, 1.0);
            reference.separation[i][lane] = between(random, -0.05, 0.02);
        }
        block.frictionX[lane] = between(random, -1.0, 1.0);
        block.frictionY[lane] = between(random, -1.0, 1.0);
        block.torsionalImpulse[lane] = between(random, -0.1, 0.1);
        set(reference.centreOffset, lane, poses[2 * lane + 1].centre - poses[2 * lane + 2].centre);
        set(reference.firstRotation, lane, poses[2 * lane + 1].rotation);
        set(reference.secondRotation, lane, poses[2 * lane + 2].rotation);
        reference.slack[lane] = between(random, 0.0, 0.02);
    }
    static void set(Vec3Row& rows, std::size_t lane, Vec3f v) {
        rows.x[lane] = v.x;
        rows.y[lane] = v.y;
        rows.z[lane] = v.z;
    }
    static void set(QuatRow& rows, std::size_t lane, Quatf q) {
        rows.x[lane] = q.x;
        rows.y[lane] = q.y;
        rows.z[lane] = q.z;
        rows.w[lane] = q.w;
    }
};

/// Whether two floats are equal up to the rounding of a few operations.
inline bool isClose(float a, float b) { return std::abs(a - b) <= 1e-6f * (1.0f + std::abs(b)); }

}  // namespace rubble::test
