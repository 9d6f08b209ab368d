#include "core/fracture/layer/LayerContext.h"

#include "core/base/Assert.h"

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
