#include "core/physics/step/SharedLoad.h"

#include "core/base/Assert.h"
#include "core/base/math/Power.h"
#include "core/physics/state/Contacts.h"

#include <algorithm>
#include <tuple>

namespace rubble {
namespace {

constexpr float kActiveSeparation = 0.002f;  // m: nearer manifolds carry load, or will in this step
constexpr float kMaxImpulseScale = 0.9f;     // part of the impulse that a sub-step may release
constexpr double kMinShared = 1.01;          // manifolds; fewer are one

/// A manifold of a body, with its normal away from the body.
struct Manifold {
    std::uint32_t other = 0;
    std::uint32_t contact = 0;
    Vec3f normal{0.0f, 0.0f, 0.0f};
    bool isActive = false;
};

bool isActive(const ContactBlock& block, std::size_t lane) {
    for (std::size_t i = 0; i < block.pointCount[lane]; ++i) {
        const PointRows& point = block.points[i];
        if (point.separation[lane] < kActiveSeparation || point.impulse[lane] > 0.0f) return true;
    }
    return false;
}

/// Whether this body handles the manifolds that it has with the other: each pair of bodies is handled once.
bool handles(const WorldState& state, std::uint32_t body, std::uint32_t other) {
    const bool isOneHull = state.bodies[body].shape->hulls.size() == 1 && state.bodies[other].shape->hulls.size() == 1;
    return !isOneHull && (body < other || !state.bodies[other].isDynamic());
}

/// Lists the manifolds that a body handles, by other body and contact.
void listManifolds(const WorldState& state, std::uint32_t body, std::vector<Manifold>& manifolds) {
    manifolds.clear();
    visitContacts(state, body, [&](std::uint32_t number, std::uint32_t other) {
        const Contact& contact = state.contacts[number];
        if (!contact.slot.isSet() || !handles(state, body, other)) return;
        const ContactBlock& block = state.colours.block(contact.slot);
        const auto lane = static_cast<std::size_t>(ContactColours::laneOf(contact.slot));
        const float sign = contact.bodies[0] == body ? 1.0f : -1.0f;
        manifolds.push_back({other, number, block.normal.at(lane) * sign, isActive(block, lane)});
    });
    std::sort(manifolds.begin(), manifolds.end(), [](const Manifold& a, const Manifold& b) {
        return std::tie(a.other, a.contact) < std::tie(b.other, b.contact);
    });
}

/// The last sharedSoftness(): most manifolds of hulls in one plane share alike.
struct LastShared {
    const Softness* ofOne = nullptr;
    double count = 0.0;
    Softness shared;

    const Softness& of(const Softness& softness, double among) {
        if (ofOne == &softness && count == among) return shared;
        ofOne = &softness;
        count = among;
        return shared = sharedSoftness(softness, among);
    }
};

/// Softens the manifolds that a body has with one other.
void softenPair(WorldState& state, std::span<const Manifold> pair, const SolverStep& step, LastShared& last) {
    for (const Manifold& manifold : pair) {
        double count = 0.0;
        for (const Manifold& sharing : pair) {
            const bool counts = sharing.isActive || sharing.contact == manifold.contact;
            if (counts) count += std::max(0.0, static_cast<double>(dot(manifold.normal, sharing.normal)));
        }
        if (count < kMinShared) continue;
        const ContactSlot slot = state.contacts[manifold.contact].slot;
        ContactBlock& block = state.colours.block(slot);
        const auto lane = static_cast<std::size_t>(ContactColours::laneOf(slot));
        const Softness& ofOne = block.againstFixed[lane] > 0.0f ? step.againstFixed : step.betweenBodies;
        const Softness& shared = last.of(ofOne, count);
        block.sharedMassScale[lane] = shared.massScale;
        block.sharedImpulseScale[lane] = shared.impulseScale;
    }
}

}  // namespace

Softness sharedSoftness(const Softness& ofOne, double count) {
    RUBBLE_ASSERT(count >= 1.0 && ofOne.massScale > 0.0f && ofOne.massScale <= 1.0f);
    const double massScale = 1.0 - power(1.0 - static_cast<double>(ofOne.massScale), 1.0 / count);
    const double impulseScale = ofOne.impulseScale * count * massScale / static_cast<double>(ofOne.massScale);
    return {ofOne.biasRate, static_cast<float>(massScale),
            std::min(kMaxImpulseScale, static_cast<float>(impulseScale))};
}

void softenSharedContacts(WorldState& state, ThreadPool& threads, const Regions& regions, const SolverStep& step) {
    if (state.compoundBodies == 0) return;
    regions.forEach(threads, [&](std::size_t region) {
        std::vector<Manifold> manifolds;
        LastShared lastShared;
        for (const std::uint32_t body : regions.bodies(region)) {
            if (!state.bodies[body].isDynamic()) continue;
            listManifolds(state, body, manifolds);
            for (auto first = manifolds.begin(); first != manifolds.end();) {
                const auto last = std::find_if(
                    first, manifolds.end(), [&](const Manifold& manifold) { return manifold.other != first->other; });
                if (last - first > 1)
                    softenPair(state, std::span(&*first, static_cast<std::size_t>(last - first)), step, lastShared);
                first = last;
            }
        }
    });
}

}  // namespace rubble
