#include "core/physics/step/MassScaling.h"

#include "core/physics/state/Contacts.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr float kMaxLent = 0.5f;  // of its mass that a body lends to those that carry it

/// Mass that a heavy body lends to one that carries it.
struct Loan {
    std::uint32_t lender = 0;
    float mass = 0.0f;  // kg
    auto operator<=>(const Loan&) const = default;
};

SymMat3f scaled(const SymMat3f& m, float s) { return {m.xx * s, m.xy * s, m.xz * s, m.yy * s, m.yz * s, m.zz * s}; }

ScaledBody scaledBody(const WorldState& state, std::uint32_t body, float mass) {
    return {body, state.bodies[body].mass / mass, state.motions[body].inverseMass, state.poses[body].inverseInertia};
}

/// Scales the bodies that carry too much. Returns what is lent to them.
std::vector<Loan> raiseMasses(WorldState& state, std::span<const Load> loads, std::vector<ScaledBody>& bodies) {
    std::vector<Loan> loans;
    for (const Load& load : loads) {
        const float mass = state.bodies[load.body].mass, needed = load.mass / kMaxLoadRatio;
        if (needed <= mass) continue;
        const ScaledBody& body = bodies.emplace_back(scaledBody(state, load.body, needed));
        state.poses[load.body].inverseInertia = scaled(body.inverseInertia, body.inverseScale);
        loans.push_back({load.source, needed - mass});
    }
    return loans;
}

/// Scales the lenders. Their moments of inertia stay: the mass is lent to bodies around them.
void lowerMasses(const WorldState& state, std::vector<Loan> loans, std::vector<ScaledBody>& bodies) {
    std::ranges::sort(loans);
    for (auto loan = loans.begin(); loan != loans.end();) {
        const std::uint32_t lender = loan->lender;
        float lent = 0.0f;
        for (; loan != loans.end() && loan->lender == lender; ++loan) lent += loan->mass;
        const float mass = state.bodies[lender].mass;
        bodies.push_back(scaledBody(state, lender, mass - std::min(lent, kMaxLent * mass)));
    }
}

void prepareContactsOf(WorldState& state, std::uint32_t body, const SolverKernels& kernels, const SolverStep& step) {
    visitContacts(state, body, [&](std::uint32_t contact, std::uint32_t) {
        const ContactSlot slot = state.contacts[contact].slot;
        if (slot.isSet()) kernels.prepare({&state.colours.block(slot), 1}, {&state.colours.reference(slot), 1}, step);
    });
}

}  // namespace

std::vector<ScaledBody> scaleMasses(WorldState& state, std::span<const BlockList> unequal, const SolverKernels& kernels,
                                    const SolverStep& step) {
    std::vector<ScaledBody> bodies;
    lowerMasses(state, raiseMasses(state, findLoads(state, unequal, step), bodies), bodies);
    for (const ScaledBody& one : bodies) state.motions[one.body].inverseMass *= one.inverseScale;
    for (const ScaledBody& one : bodies) prepareContactsOf(state, one.body, kernels, step);
    return bodies;
}

void correctGravity(WorldState& state, std::span<const ScaledBody> bodies, const SolverStep& step) {
    for (const ScaledBody& one : bodies) {
        BodyMotion& motion = state.motions[one.body];
        const float damping = 1.0f / (1.0f + step.subStep * motion.linearDamping);
        motion.velocity += step.gravity * (step.subStep * (one.inverseScale - 1.0f) * damping);
    }
}

void restoreMasses(WorldState& state, std::span<const ScaledBody> bodies) {
    for (const ScaledBody& one : bodies) {
        state.motions[one.body].inverseMass = one.inverseMass;
        state.poses[one.body].inverseInertia = one.inverseInertia;
    }
}

}  // namespace rubble
