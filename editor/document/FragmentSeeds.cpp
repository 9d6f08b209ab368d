#include "editor/document/FragmentSeeds.h"

namespace rubble {

std::vector<SeedId> seedsOfFragments(const Bake& bake) {
    std::vector<SeedId> seeds;
    seeds.reserve(bake.fragmentCount());
    for (const BakedBreaking& breaking : bake.breakings) {
        for (std::uint32_t k = 0; k < breaking.fragments.count(); ++k) {
            const std::uint32_t seed = breaking.fragments[k].seed();
            if (breaking.parent != kNone) {
                seeds.push_back(seeds[breaking.parent]);  // numbered before its pieces
            } else {
                seeds.push_back(seed == kNone ? SeedId{} : breaking.seeds.ids[seed]);
            }
        }
    }
    return seeds;
}

}  // namespace rubble
