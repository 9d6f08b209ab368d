#include "core/fracture/layer/LayerContext.h"

#include "core/base/Assert.h"
#include "core/base/MessageText.h"
#include "core/fracture/sampling/PairIndex.h"

#include <algorithm>

namespace rubble {
namespace {

Result<std::uint32_t> withinLimit(double wanted, const EvaluatedLayer& layer, const SeedSet& seeds) {
    if (!(wanted <= static_cast<double>(kMaxSeeds - seeds.size()))) return tooManySeeds(layer);
    return static_cast<std::uint32_t>(wanted);
}

}  // namespace

void SeedSet::add(SeedId id, Vec2 position, bool locked) {
    positions.push_back(position);
    ids.push_back(id);
    isLocked.push_back(locked);
    RUBBLE_ASSERT(heights.empty());
}

void SeedSet::add(SeedId id, Vec3 position, bool locked) {
    RUBBLE_ASSERT(heights.size() == positions.size());
    positions.push_back(Vec2(position));
    heights.push_back(position.z);
    ids.push_back(id);
    isLocked.push_back(locked);
}

void SeedSet::reserve(std::size_t additional) {
    positions.reserve(size() + additional);
    ids.reserve(size() + additional);
    isLocked.reserve(size() + additional);
}

void SeedSet::remove(std::size_t first, const std::vector<bool>& isRemoved) {
    std::size_t kept = first;
    for (std::size_t seed = first; seed < size(); ++seed) {
        if (isRemoved[seed - first]) continue;
        positions[kept] = positions[seed];
        if (!heights.empty()) heights[kept] = heights[seed];
        ids[kept] = ids[seed];
        isLocked[kept] = isLocked[seed];
        ++kept;
    }
    positions.resize(kept);
    if (!heights.empty()) heights.resize(kept);
    ids.resize(kept);
    isLocked.resize(kept);
}

std::string EvaluatedLayer::name() const { return "Layer " + std::to_string(layerId); }

Error tooManyNumbers(const SolidLayerContext& context, const char* what, double count) {
    return {ErrorCode::Limit, context.name() + " has " + messageText(count) + " " + what + ", but " +
                                  std::to_string(kMaxTripleNumber) + " is the maximum on a mesh."};
}

void addByIndex(std::vector<IndexedPlace>& places, const SolidLayerContext& context, SeedSet& seeds) {
    std::ranges::sort(places, {}, &IndexedPlace::index);
    seeds.reserve(places.size());
    for (const IndexedPlace& place : places) seeds.add({context.layerId, place.index}, place.position, false);
}

Error tooManySeeds(const EvaluatedLayer& layer) {
    return {ErrorCode::Limit, layer.name() + " brings the pattern above " + std::to_string(kMaxSeeds) + " seeds."};
}

Result<std::uint32_t> seedsToAdd(const SeedCount& count, const Polygon& domain, const LayerContext& context,
                                 const SeedSet& seeds) {
    return withinLimit(count.in(area(domain)), context, seeds);
}

Result<std::uint32_t> seedsToAdd(const SeedCount& count, double volume, const SolidLayerContext& context,
                                 const SeedSet& seeds) {
    return withinLimit(count.in(volume, SeedSpace::Solid), context, seeds);
}

}  // namespace rubble
