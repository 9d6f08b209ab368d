#include "core/fracture/layer/LayerContext.h"

namespace rubble {

void SeedSet::add(SeedId id, Vec2 position, bool locked) {
    positions.push_back(position);
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
        ids[kept] = ids[seed];
        isLocked[kept] = isLocked[seed];
        ++kept;
    }
    positions.resize(kept);
    ids.resize(kept);
    isLocked.resize(kept);
}

std::string LayerContext::name() const { return "Layer " + std::to_string(layerId); }

Error tooManySeeds(const LayerContext& context) {
    return {ErrorCode::Limit, context.name() + " brings the pattern above " + std::to_string(kMaxSeeds) + " seeds."};
}

Result<std::uint32_t> seedsToAdd(const SeedCount& count, const Polygon& domain, const LayerContext& context,
                                 const SeedSet& seeds) {
    const double wanted = count.in(area(domain));
    if (!(wanted <= static_cast<double>(kMaxSeeds - seeds.size()))) return tooManySeeds(context);
    return static_cast<std::uint32_t>(wanted);
}

}  // namespace rubble
