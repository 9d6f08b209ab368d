#include "core/physics/step/SharedLoad.h"

#include "core/base/Assert.h"
#include "core/base/math/Power.h"

#include <algorithm>
#include <tuple>

namespace rubble {
namespace {

constexpr float kActiveSeparation = 0.002f;  // m: nearer manifolds carry load, or will in this step
constexpr float kMaxImpulseScale = 0.9f;     // part of the impulse that a sub-step may release
constexpr double kMinShared = 1.01;          // manifolds; fewer are one

/// Where a manifold is of two bodies of which at least one has several hulls.
struct ManifoldPlace {
    std::uint32_t low = 0;  // bodies, low < high
    std::uint32_t high = 0;
    std::uint32_t contact = 0;
    std::size_t lane = 0;
    ContactBlock* block = nullptr;
    auto order() const { return std::tie(low, high, contact); }
};

/// A manifold with its normal from the lower to the higher body.
struct Manifold {
    ContactBlock* block = nullptr;
    std::size_t lane = 0;
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

bool hasSeveralHulls(const WorldState& state, std::uint32_t body) {
    const std::uint32_t proxy = state.bodies[body].firstProxy;
    return proxy != kNone && state.proxies[proxy].next != kNone;
}

/// The manifolds of bodies of several hulls, by bodies and contact. It reads the blocks one after the other: the lists
/// of contacts of all bodies are scattered in memory.
std::vector<ManifoldPlace> sharedManifolds(WorldState& state, ThreadPool& threads, const Regions& regions) {
    std::vector<std::vector<ManifoldPlace>> found(regions.count());
    regions.forEach(threads, [&](std::size_t region) {
        for (std::size_t number = 0; number < ContactColours::kLists; ++number) {
            const std::span blocks = regions.part(number, std::span(state.colours.lists()[number].blocks), region);
            for (ContactBlock& block : blocks) {
                for (std::size_t lane = 0; lane < kBlockLanes; ++lane) {
                    const std::uint32_t first = block.first[lane], second = block.second[lane];
                    if (first == second) continue;  // an empty lane
                    if (!hasSeveralHulls(state, first) && !hasSeveralHulls(state, second)) continue;
                    found[region].push_back(
                        {std::min(first, second), std::max(first, second), block.contact[lane], lane, &block});
                }
            }
        }
    });
    for (std::size_t region = 1; region < found.size(); ++region)
        found[0].insert(found[0].end(), found[region].begin(), found[region].end());
    std::sort(found[0].begin(), found[0].end(),
              [](const ManifoldPlace& a, const ManifoldPlace& b) { return a.order() < b.order(); });
    return std::move(found[0]);
}

Manifold manifoldAt(const ManifoldPlace& place) {
    const ContactBlock& block = *place.block;
    const float sign = block.first[place.lane] == place.low ? 1.0f : -1.0f;
    return {place.block, place.lane, block.normal.at(place.lane) * sign, isActive(block, place.lane)};
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

/// Softens the manifolds that two bodies have with each other.
void softenPair(std::span<const Manifold> pair, const SolverStep& step, LastShared& last) {
    for (const Manifold& manifold : pair) {
        double count = 0.0;
        for (const Manifold& sharing : pair) {
            if (sharing.isActive || &sharing == &manifold)
                count += std::max(0.0, static_cast<double>(dot(manifold.normal, sharing.normal)));
        }
        if (count < kMinShared) continue;
        ContactBlock& block = *manifold.block;
        const Softness& ofOne = block.againstFixed[manifold.lane] > 0.0f ? step.againstFixed : step.betweenBodies;
        const Softness& shared = last.of(ofOne, count);
        block.sharedMassScale[manifold.lane] = shared.massScale;
        block.sharedImpulseScale[manifold.lane] = shared.impulseScale;
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
    if (state.compoundBodies == 0 || state.colours.contactCount() == 0) return;
    const std::vector<ManifoldPlace> places = sharedManifolds(state, threads, regions);
    std::vector<Manifold> pair;
    LastShared lastShared;
    for (std::size_t begin = 0, end = 0; begin < places.size(); begin = end) {
        while (end < places.size() && places[end].low == places[begin].low && places[end].high == places[begin].high)
            ++end;
        if (end - begin < 2) continue;
        pair.clear();
        for (std::size_t k = begin; k < end; ++k) pair.push_back(manifoldAt(places[k]));
        softenPair(pair, step, lastShared);
    }
}

}  // namespace rubble
