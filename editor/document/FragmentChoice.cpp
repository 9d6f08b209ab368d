#include "editor/document/FragmentChoice.h"

#include "editor/document/FragmentSeeds.h"

namespace rubble {

FragmentSet fragmentsOf(const FragmentChoice& choice, const Bake& bake) {
    FragmentSet set(bake.fragmentCount(), false);
    if (choice.isEmpty()) return set;
    const std::vector<SeedId> seeds = seedsOfFragments(bake);
    for (std::uint32_t k = 0; k < set.size(); ++k) {
        set[k] = choice.seeds.contains(seeds[k]) && (!choice.ids || choice.ids->contains(bake.fragmentId(k)));
    }
    return set;
}

FragmentChoice choiceOf(const FragmentSet& set, const Bake& bake) {
    FragmentChoice choice;
    const std::vector<SeedId> seeds = seedsOfFragments(bake);
    for (std::uint32_t k = 0; k < set.size(); ++k) {
        if (set[k]) choice.seeds.insert(seeds[k]);
    }
    if (choice.isEmpty() || fragmentsOf(choice, bake) == set) return choice;
    choice.ids.emplace();
    for (std::uint32_t k = 0; k < set.size(); ++k) {
        if (set[k]) choice.ids->insert(bake.fragmentId(k));
    }
    return choice;
}

}  // namespace rubble
