#include "editor/document/FragmentSeeds.h"

#include "core/asset/FragmentPlace.h"
#include "core/fracture/PatternPartition.h"

namespace rubble {

std::vector<SeedId> seedsOfFragments(const Bake& bake) {
    std::vector<SeedId> seeds;
    seeds.reserve(bake.fragmentCount());
    for (const std::optional<SeedId>& seed : seedsOfFragments(bake, {})) seeds.push_back(*seed);
    return seeds;
}

std::vector<std::optional<SeedId>> seedsOfFragments(const Bake& bake, const FragmentPath& inside) {
    std::vector<std::optional<SeedId>> seeds(bake.fragmentCount());
    const std::optional<std::uint32_t> broken = fragmentAt(bake, inside);
    if (!broken) return seeds;
    for (const BakedBreaking& breaking : bake.breakings) {
        for (std::uint32_t k = 0; k < breaking.fragments.count(); ++k) {
            std::optional<SeedId>& seed = seeds[breaking.first + k];
            if (breaking.parent == *broken) {
                seed = cellId(breaking.fragments.partition, breaking.fragments[k].piece(), breaking.seeds.ids);
            } else if (breaking.parent != kNone) {
                seed = seeds[breaking.parent];  // numbered before its pieces
            }
        }
    }
    return seeds;
}

}  // namespace rubble
