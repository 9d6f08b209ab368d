#include "core/physics/step/ContactEnergy.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rubble {
namespace {

/// Whether a body moved in the step as where nothing but gravity and damping acts on it: bit for bit as the solver
/// computes it, with the displacement, which continuous collision may have corrected.
bool fliesFreely(const StartMotion& start, const BodyMotion& now, const SolverStep& step) {
    const float h = step.subStep;
    const float linear = 1.0f / (1.0f + h * now.linearDamping), angular = 1.0f / (1.0f + h * now.angularDamping);
    Vec3f velocity = start.velocity, angularVelocity = start.angularVelocity, displacement(0.0f);
    for (int k = static_cast<int>(std::lround(step.dt / h)); k > 0; --k) {
        velocity.x = (velocity.x + h * step.gravity.x) * linear;
        velocity.y = (velocity.y + h * step.gravity.y) * linear;
        velocity.z = (velocity.z + h * step.gravity.z) * linear;
        angularVelocity *= angular;
        displacement += velocity * h;
    }
    return velocity == now.velocity && angularVelocity == now.angularVelocity && displacement == now.deltaPosition;
}

/// The work of gravity on a body in the step, less that at its mean velocity, J.
double gravityBeyondMean(const WorldState& state, std::uint32_t number, const SolverStep& step,
                         const StartMotion& start) {
    if (!state.bodies[number].isDynamic()) return 0.0;
    const BodyMotion& motion = state.motions[number];
    const Vec3 mean = 0.5 * (toDouble(motion.velocity) + toDouble(start.velocity));
    return state.bodies[number].mass *
           glm::dot(toDouble(step.gravity), toDouble(motion.deltaPosition) - mean * static_cast<double>(step.dt));
}

/// The mean of the velocities before and after the step.
struct MeanMotion {
    Vec3 velocity, angularVelocity;
    Vec3 at(Vec3 arm) const { return velocity + glm::cross(angularVelocity, arm); }
};

MeanMotion meanMotion(const WorldState& state, std::uint32_t number, const std::vector<StartMotion>& starts) {
    const BodyMotion& motion = state.motions[number];
    if (!state.bodies[number].isAwake) return {toDouble(motion.velocity), toDouble(motion.angularVelocity)};
    return {0.5 * (toDouble(starts[number].velocity) + toDouble(motion.velocity)),
            0.5 * (toDouble(starts[number].angularVelocity) + toDouble(motion.angularVelocity))};
}

}  // namespace

void saveStartMotions(const WorldState& state, ThreadPool& threads, const Regions& regions,
                      ContactEnergyScratch& scratch) {
    scratch.starts.resize(state.bodies.size());
    scratch.losses.resize(state.bodies.size());
    regions.forEach(threads, [&](std::size_t region) {
        for (const std::uint32_t body : regions.bodies(region)) {
            const BodyMotion& motion = state.motions[body];
            scratch.starts[body] = {motion.velocity, motion.inverseMass, motion.angularVelocity, motion.linearDamping};
        }
    });
}

void findLosses(const WorldState& state, ThreadPool& threads, const Regions& regions, const SolverKernels& kernels,
                const SolverStep& step, ContactEnergyScratch& scratch) {
    regions.forEach(threads, [&](std::size_t region) {
        const std::span<const std::uint32_t> bodies = regions.bodies(region);
        kernels.findLosses(bodies, step, scratch.starts.data(), scratch.losses.data());
        for (const std::uint32_t body : bodies) {
            if (scratch.losses[body].mayBeFree && fliesFreely(scratch.starts[body], state.motions[body], step)) {
                scratch.losses[body].energy = 0.0f;
            }
        }
    });
}

double contactLoss(const WorldState& state, const ContactEnergyScratch& scratch) {
    double sum = 0.0;  // in the order of the bodies, on any number of threads
    for (const std::uint32_t body : state.awake) sum += static_cast<double>(scratch.losses[body].energy);
    return sum;
}

double contactEnergy(const WorldState& state, const ContactBlock& block, std::size_t lane,
                     const std::vector<StartMotion>& starts) {
    const MeanMotion first = meanMotion(state, block.first[lane], starts);
    const MeanMotion second = meanMotion(state, block.second[lane], starts);
    const Vec3 normal = toDouble(block.normal.at(lane)), tangent = toDouble(block.tangent.at(lane));
    const Vec3 centreOffset = toDouble(block.centreOffset.at(lane));
    const auto speedAt = [&](Vec3 arm) { return second.at(arm + centreOffset) - first.at(arm); };
    double gained = block.stepTorsionalImpulse[lane] * glm::dot(normal, second.angularVelocity - first.angularVelocity);
    for (std::size_t i = 0; i < block.pointCount[lane]; ++i) {
        const PointRows& point = block.points[i];
        gained += point.stepImpulse[lane] * glm::dot(normal, speedAt(toDouble(point.position.at(lane))));
    }
    const Vec3 friction = static_cast<double>(block.stepFrictionX[lane]) * tangent +
                          static_cast<double>(block.stepFrictionY[lane]) * glm::cross(normal, tangent);
    gained += glm::dot(friction, speedAt(toDouble(block.frictionCentre.at(lane))));
    return -gained;
}

void addGravity(const WorldState& state, const SolverStep& step, const std::vector<StartMotion>& starts,
                std::vector<HitEvent>& hits) {
    struct BodyHit {
        std::uint32_t body = 0;
        double impulse = 0.0;
        std::size_t hit = 0;
    };
    std::vector<BodyHit> ofBodies;
    for (std::size_t k = 0; k < hits.size(); ++k) {
        ofBodies.push_back({hits[k].first.index, hits[k].impulse, k});
        ofBodies.push_back({hits[k].second.index, hits[k].impulse, k});
    }
    std::ranges::sort(ofBodies, [](const BodyHit& a, const BodyHit& b) {
        return std::tuple(a.body, -a.impulse, a.hit) < std::tuple(b.body, -b.impulse, b.hit);
    });
    std::uint32_t last = 0;
    for (const BodyHit& one : ofBodies) {
        if (one.body == last) continue;
        last = one.body;
        if (!state.bodies[one.body].isAwake) continue;
        hits[one.hit].energy += gravityBeyondMean(state, one.body, step, starts[one.body]);
    }
}

void limitHits(std::vector<HitEvent>& hits, double loss) {
    double taken = 0.0;
    for (const HitEvent& hit : hits) taken += std::max(hit.energy, 0.0);
    if (taken <= std::max(loss, 0.0)) return;
    const double kept = std::max(loss, 0.0) / taken;
    for (HitEvent& hit : hits) hit.energy = std::max(hit.energy, 0.0) * kept;
}

}  // namespace rubble
