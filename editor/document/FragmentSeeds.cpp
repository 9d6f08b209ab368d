#include "editor/document/FragmentSeeds.h"

#include "core/asset/bake/FragmentLookup.h"
#include "core/fracture/fragments/FragmentName.h"

namespace rubble {

std::vector<SeedId> seedsOfFragments(const Bake& bake) {
    std::vector<SeedId> seeds;
    seeds.reserve(bake.fragmentCount());
    for (const std::optional<SeedId>& seed : seedsOfFragments(bake, {})) seeds.push_back(*seed);
    return seeds;
}

std::vector<std::optional<SeedId>> seedsOfFragments(const Bake& bake, const FragmentPath& parent) {
    std::vector<std::optional<SeedId>> seeds(bake.fragmentCount());
    const std::optional<std::uint32_t> fractured = fragmentAt(bake, parent);
    if (!fractured) return seeds;
    for (const BakedFracture& fracture : bake.fractures) {
        for (std::uint32_t k = 0; k < fracture.fragments.count(); ++k) {
            std::optional<SeedId>& seed = seeds[fracture.first + k];
            if (fracture.parent == *fractured) {
                seed = cellId(fracture.fragments[k], fracture.seeds.ids);
            } else if (fracture.parent != kNone) {
                seed = seeds[fracture.parent];  // it has a lower index
            }
        }
    }
    return seeds;
}

}  // namespace rubble
