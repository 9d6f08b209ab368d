#include "core/fracture/pattern/SeedEdits.h"

#include "core/base/Assert.h"
#include "core/fracture/pattern/PatternKind.h"

#include <algorithm>

namespace rubble {
namespace {

template <class Element>
auto lowerBound(std::vector<Element>& elements, std::uint32_t index) {
    return std::ranges::lower_bound(elements, index, {}, &Element::index);
}

void setOverride(PatternLayer& layer, const SeedOverride& change) {
    if (kindOf(layer.parameters).role != LayerRole::Scatters) return;
    const auto found = lowerBound(layer.overrides, change.index);
    if (found != layer.overrides.end() && found->index == change.index) {
        *found = change;
    } else {
        layer.overrides.insert(found, change);
    }
}

}  // namespace

void moveSeed(Pattern& pattern, SeedId seed, Vec2 position) { moveSeed(pattern, seed, Vec3(position, 0.0)); }

void moveSeed(Pattern& pattern, SeedId seed, Vec3 position) {
    PatternLayer* layer = findLayer(pattern, seed.layer);
    if (!layer) return;
    auto* placed = std::get_if<PlacedSeeds>(&layer->parameters);
    if (!placed) return setOverride(*layer, {.index = seed.index, .position = Vec2(position), .height = position.z});
    const auto found = lowerBound(placed->seeds, seed.index);
    if (found != placed->seeds.end() && found->index == seed.index) *found = {seed.index, Vec2(position), position.z};
}

void deleteSeed(Pattern& pattern, SeedId seed) {
    PatternLayer* layer = findLayer(pattern, seed.layer);
    if (!layer) return;
    auto* placed = std::get_if<PlacedSeeds>(&layer->parameters);
    if (!placed) return setOverride(*layer, {.index = seed.index, .isDeleted = true});
    const auto found = lowerBound(placed->seeds, seed.index);
    if (found != placed->seeds.end() && found->index == seed.index) placed->seeds.erase(found);
}

void restoreSeed(Pattern& pattern, SeedId seed) {
    PatternLayer* layer = findLayer(pattern, seed.layer);
    if (!layer) return;
    const auto found = lowerBound(layer->overrides, seed.index);
    if (found != layer->overrides.end() && found->index == seed.index) layer->overrides.erase(found);
}

SeedId placeSeed(PatternLayer& layer, Vec2 position) { return placeSeed(layer, Vec3(position, 0.0)); }

SeedId placeSeed(PatternLayer& layer, Vec3 position) {
    std::vector<PlacedSeeds::Seed>& seeds = std::get<PlacedSeeds>(layer.parameters).seeds;
    const std::uint32_t index = seeds.empty() ? 0 : seeds.back().index + 1;
    seeds.push_back({index, Vec2(position), position.z});
    return {layer.id, index};
}

PatternLayer* findLayer(Pattern& pattern, std::uint32_t id) {
    const auto layer = std::ranges::find(pattern.layers, id, &PatternLayer::id);
    return layer == pattern.layers.end() ? nullptr : &*layer;
}

const PatternLayer* findLayer(const Pattern& pattern, std::uint32_t id) {
    return findLayer(const_cast<Pattern&>(pattern), id);
}

}  // namespace rubble
