#include "core/physics/step/WarmStart.h"

#include "core/physics/step/BodyManifolds.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr float kThrownSpeed = 0.5f;  // m/s
constexpr float kMaxFraction = 0.5f;  // of the changes that the contacts of a body would cause alone

/// A change of velocities.
struct Change {
    Vec3f velocity{0.0f, 0.0f, 0.0f};         // m/s
    Vec3f angularVelocity{0.0f, 0.0f, 0.0f};  // rad/s
};

/// The speed at which a body, without rotating, would have the energy of a change, m/s.
float speedOf(const WorldState& state, std::uint32_t number, const Change& change) {
    const Body& body = state.bodies[number];
    const Vec3f spin = state.poses[number].rotation.matrix().transposedTimes(change.angularVelocity);
    return std::sqrt(lengthSquared(change.velocity) + dot(spin, body.inertia * spin) / body.mass);
}

Change changeSince(const WorldState& state, std::uint32_t body, const StartMotion& start, const SolverStep& step) {
    const BodyMotion& motion = state.motions[body];
    return {motion.velocity - start.velocity - step.gravity * step.subStep,
            motion.angularVelocity - start.angularVelocity};
}

/// What warm starting does to both bodies of a contact.
struct Push {
    Vec3f impulse{0.0f, 0.0f, 0.0f};       // N·s, on the second
    Vec3f firstMoment{0.0f, 0.0f, 0.0f};   // N·m·s, about the centre of the first
    Vec3f secondMoment{0.0f, 0.0f, 0.0f};  // the same of the second, with the opposite sign of the first's
};

Push pushOf(const ContactBlock& block, std::size_t lane) {
    const Vec3f normal = block.normal.at(lane), tangent = block.tangent.at(lane);
    Push push;
    const auto add = [&](Vec3f impulse, Vec3f position) {
        push.impulse += impulse;
        push.firstMoment += cross(position, impulse);
    };
    for (std::size_t i = 0; i < block.pointCount[lane]; ++i)
        add(normal * block.points[i].impulse[lane], block.points[i].position.at(lane));
    add(tangent * block.frictionX[lane] + cross(normal, tangent) * block.frictionY[lane],
        block.frictionCentre.at(lane));
    push.firstMoment += normal * block.torsionalImpulse[lane];
    push.secondMoment = push.firstMoment + cross(block.centreOffset.at(lane), push.impulse);
    return push;
}

/// The change of a body of the contact by its warm starting.
Change changeOf(const WorldState& state, const ContactBlock& block, std::size_t lane, const Push& push,
                std::uint32_t body) {
    const float sign = block.first[lane] == body ? -1.0f : 1.0f;
    const Vec3f moment = block.first[lane] == body ? push.firstMoment : push.secondMoment;
    return {push.impulse * (sign * state.motions[body].inverseMass),
            state.poses[body].inverseInertia * (moment * sign)};
}

/// Takes back the warm starting of a contact.
void takeBack(WorldState& state, ContactBlock& block, std::size_t lane) {
    const Push push = pushOf(block, lane);
    for (const std::uint32_t body : {block.first[lane], block.second[lane]}) {
        if (!state.bodies[body].isDynamic()) continue;
        const Change change = changeOf(state, block, lane, push, body);
        state.motions[body].velocity -= change.velocity;
        state.motions[body].angularVelocity -= change.angularVelocity;
    }
    for (PointRows& point : block.points) point.impulse[lane] = 0.0f;
    block.frictionX[lane] = block.frictionY[lane] = block.torsionalImpulse[lane] = 0.0f;
}

}  // namespace

bool isThrown(const WorldState& state, std::uint32_t body, const StartMotion& start, const SolverStep& step) {
    const Change change = changeSince(state, body, start, step);
    const float radius = state.poses[body].boundingRadius;  // more than that of gyration
    const float most = lengthSquared(change.velocity) + radius * radius * lengthSquared(change.angularVelocity);
    if (most <= kThrownSpeed * kThrownSpeed) return false;
    return state.bodies[body].isDynamic() && speedOf(state, body, change) > kThrownSpeed;
}

void dropUnbalancedImpulses(WorldState& state, std::vector<std::uint32_t>& thrown, std::span<const StartMotion> starts,
                            const SolverStep& step) {
    BodyManifolds manifolds;
    for (std::size_t k = 0; k < thrown.size(); ++k) {  // grows: a body without its support throws the next one
        const std::uint32_t body = thrown[k];
        Change sum;
        float all = 0.0f;
        manifolds.visit(state, body, [&](const ContactBlock& block, std::size_t lane, std::uint32_t) {
            const Change change = changeOf(state, block, lane, pushOf(block, lane), body);
            sum.velocity += change.velocity;
            sum.angularVelocity += change.angularVelocity;
            all += speedOf(state, body, change);
        });
        if (speedOf(state, body, sum) <= std::max(kThrownSpeed, kMaxFraction * all)) continue;
        manifolds.visit(state, body, [&](ContactBlock& block, std::size_t lane, std::uint32_t other) {
            takeBack(state, block, lane);
            if (isThrown(state, other, starts[other], step)) thrown.push_back(other);
        });
    }
}

}  // namespace rubble
