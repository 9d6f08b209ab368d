#include "core/fracture/SeedEdits.h"

#include "core/base/Assert.h"
#include "core/fracture/PatternKind.h"

#include <algorithm>

namespace rubble {
namespace {

template <class Element>
auto placeOf(std::vector<Element>& elements, std::uint32_t index) {
    return std::ranges::lower_bound(elements, index, {}, &Element::index);
}

void setOverride(PatternLayer& layer, const SeedOverride& change) {
    if (kindOf(layer.parameters).role != LayerRole::Scatters) return;
    const auto place = placeOf(layer.overrides, change.index);
    if (place != layer.overrides.end() && place->index == change.index) {
        *place = change;
    } else {
        layer.overrides.insert(place, change);
    }
}

}  // namespace

void moveSeed(Pattern& pattern, SeedId seed, Vec2 position) {
    PatternLayer* layer = findLayer(pattern, seed.layer);
    if (!layer) return;
    auto* placed = std::get_if<PlacedSeeds>(&layer->parameters);
    if (!placed) return setOverride(*layer, {.index = seed.index, .position = position});
    const auto place = placeOf(placed->seeds, seed.index);
    if (place != placed->seeds.end() && place->index == seed.index) place->position = position;
}

void deleteSeed(Pattern& pattern, SeedId seed) {
    PatternLayer* layer = findLayer(pattern, seed.layer);
    if (!layer) return;
    auto* placed = std::get_if<PlacedSeeds>(&layer->parameters);
    if (!placed) return setOverride(*layer, {.index = seed.index, .isDeleted = true});
    const auto place = placeOf(placed->seeds, seed.index);
    if (place != placed->seeds.end() && place->index == seed.index) placed->seeds.erase(place);
}

void restoreSeed(Pattern& pattern, SeedId seed) {
    PatternLayer* layer = findLayer(pattern, seed.layer);
    if (!layer) return;
    const auto place = placeOf(layer->overrides, seed.index);
    if (place != layer->overrides.end() && place->index == seed.index) layer->overrides.erase(place);
}

SeedId placeSeed(PatternLayer& layer, Vec2 position) {
    std::vector<PlacedSeeds::Seed>& seeds = std::get<PlacedSeeds>(layer.parameters).seeds;
    const std::uint32_t index = seeds.empty() ? 0 : seeds.back().index + 1;
    seeds.push_back({index, position});
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
