#include "editor/document/FragmentChoice.h"

#include "core/asset/FragmentPlace.h"
#include "editor/document/FragmentSeeds.h"

#include <algorithm>

namespace rubble {

namespace {

/// The seed of the pattern inside `of` that a fragment in there comes from.
SeedId seedInside(const FragmentPath& of, const FragmentPath& path) {
    const std::optional<PieceName> name = pieceNameOf(pieceOf(of, path));
    return name ? name->seed : SeedId{};
}

}  // namespace

bool FragmentChoice::holds(const FragmentPath& of, SeedId seed, const std::string& id) const {
    if (!isWithin(of, inside)) return false;
    return seeds.contains(of == inside ? seed : seedInside(inside, of)) && (!ids || ids->contains(id));
}

FragmentChoice::Seeds FragmentChoice::seedsInside(const FragmentPath& of) const {
    if (of == inside) return seeds;
    if (isEmpty()) return {};
    if (isWithin(inside, of)) return {seedInside(of, inside)};
    Seeds found;
    for (const std::string& id : ids.value_or(Ids())) {
        const FragmentPath path = pathOfId(id);
        if (path != of && isWithin(path, of)) found.insert(seedInside(of, path));
    }
    return found;
}

FragmentSet fragmentsOf(const FragmentChoice& choice, const Bake& bake) {
    FragmentSet set(bake.fragmentCount(), false);
    if (choice.isEmpty()) return set;
    const std::vector<std::optional<SeedId>> seeds = seedsOfFragments(bake, choice.inside);
    for (std::uint32_t k = 0; k < set.size(); ++k) {
        if (!seeds[k] || !choice.seeds.contains(*seeds[k])) continue;
        set[k] = !choice.ids || choice.ids->contains(bake.fragmentId(k));
    }
    return set;
}

FragmentChoice choiceOf(const FragmentSet& set, const Bake& bake, const FragmentPath& inside) {
    FragmentChoice choice{.inside = inside};
    const std::vector<std::optional<SeedId>> seeds = seedsOfFragments(bake, inside);
    for (std::uint32_t k = 0; k < set.size(); ++k) {
        if (!set[k]) continue;
        if (!seeds[k]) return choiceOf(set, bake);
        choice.seeds.insert(*seeds[k]);
    }
    if (choice.isEmpty()) return {};
    if (fragmentsOf(choice, bake) == set) return choice;
    choice.ids.emplace();
    for (std::uint32_t k = 0; k < set.size(); ++k) {
        if (set[k]) choice.ids->insert(bake.fragmentId(k));
    }
    return choice;
}

}  // namespace rubble
