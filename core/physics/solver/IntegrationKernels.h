#pragma once

#include "core/physics/solver/ContactLanes.h"

namespace rubble {

/// The passes over bodies: integration of velocities and positions.
template <int W>
struct IntegrationKernels : ContactLanes<W> {
    using Lanes = ContactLanes<W>;
    using F = typename Lanes::F;
    using V = typename Lanes::V;
    using Q = typename Lanes::Q;
    using Lanes::motions;
    using typename Lanes::Motions;

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
            motion.angularVelocity.x *= angular;
            motion.angularVelocity.y *= angular;
            motion.angularVelocity.z *= angular;
        }
    }

    static void integratePositions(std::span<const std::uint32_t> bodies, const SolverStep& step) {
        const F h = all<W>(step.subStep), half = all<W>(0.5f * step.subStep);
        for (std::size_t first = 0; first < bodies.size(); first += W) {
            const int count = bodies.size() - first < W ? static_cast<int>(bodies.size() - first) : W;
            IndexRow index{};
            for (int lane = 0; lane < count; ++lane) index[lane] = bodies[first + lane];
            const Motions m = motions(index, 0, step);
            const V deltaPosition = m.deltaPosition + m.linear * h;
            const V w = m.angularVelocity * half;
            const Q& q = m.deltaRotation;
            Q next{q.x + w.x * q.w + w.y * q.z - w.z * q.y, q.y - w.x * q.z + w.y * q.w + w.z * q.x,
                   q.z + w.x * q.y - w.y * q.x + w.z * q.w, q.w - w.x * q.x - w.y * q.y - w.z * q.z};
            const F scale = 1.0f / squareRoot<W>(next.x * next.x + next.y * next.y + next.z * next.z + next.w * next.w);
            F angularDamping{};
            for (int lane = 0; lane < count; ++lane) angularDamping[lane] = step.motions[index[lane]].angularDamping;
            F c[8] = {deltaPosition.x, deltaPosition.y, deltaPosition.z, angularDamping,
                      next.x * scale,  next.y * scale,  next.z * scale,  next.w * scale};
            for (int chunk = 0; chunk < 8; chunk += W) transpose<W>(c + chunk);
            for (int lane = 0; lane < count; ++lane) {
                float* to = &step.motions[index[lane]].deltaPosition.x;
                for (int chunk = 0; chunk < 8; chunk += W) store<W>(c[chunk + lane], to + chunk);
            }
        }
    }
};

}  // namespace rubble
