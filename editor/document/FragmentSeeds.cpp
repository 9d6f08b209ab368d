#include "editor/document/FragmentSeeds.h"

#include "core/fracture/PatternPartition.h"

namespace rubble {

std::vector<SeedId> seedsOfFragments(const Bake& bake) {
    std::vector<SeedId> seeds;
    seeds.reserve(bake.fragmentCount());
    for (const BakedBreaking& breaking : bake.breakings) {
        for (std::uint32_t k = 0; k < breaking.fragments.count(); ++k) {
            const Fragment fragment = breaking.fragments[k];
            if (breaking.parent != kNone) {
                seeds.push_back(seeds[breaking.parent]);  // numbered before its pieces
            } else {
                seeds.push_back(cellId(fragment.all().partition, fragment.piece(), breaking.seeds.ids));
            }
        }
    }
    return seeds;
}

}  // namespace rubble
