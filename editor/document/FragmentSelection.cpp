#include "editor/document/FragmentSelection.h"

#include "core/asset/bake/FragmentLookup.h"
#include "editor/document/FragmentSeeds.h"

#include <algorithm>

namespace rubble {

namespace {

/// The seed of the pattern of `parent` that its descendant `path` comes from.
SeedId seedWithin(const FragmentPath& parent, const FragmentPath& path) {
    const std::optional<PieceName> name = pieceNameOf(childOnPath(parent, path));
    return name ? name->seed : SeedId{};
}

}  // namespace

bool FragmentSelection::contains(const FragmentPath& fragment, SeedId seed, const std::string& id) const {
    if (!isWithin(fragment, parent)) return false;
    return seeds.contains(fragment == parent ? seed : seedWithin(parent, fragment)) && (!ids || ids->contains(id));
}

FragmentSelection::Seeds FragmentSelection::seedsOf(const FragmentPath& fragment) const {
    if (fragment == parent) return seeds;
    if (isEmpty()) return {};
    if (isWithin(parent, fragment)) return {seedWithin(fragment, parent)};
    Seeds found;
    for (const std::string& id : ids.value_or(Ids())) {
        const FragmentPath path = pathOfId(id);
        if (path != fragment && isWithin(path, fragment)) found.insert(seedWithin(fragment, path));
    }
    return found;
}

FragmentSet fragmentsOf(const FragmentSelection& selection, const Bake& bake) {
    FragmentSet set(bake.fragmentCount(), false);
    if (selection.isEmpty()) return set;
    const std::vector<std::optional<SeedId>> seeds = seedsOfFragments(bake, selection.parent);
    for (std::uint32_t k = 0; k < set.size(); ++k) {
        if (!seeds[k] || !selection.seeds.contains(*seeds[k])) continue;
        set[k] = !selection.ids || selection.ids->contains(bake.fragmentId(k));
    }
    return set;
}

FragmentSelection selectionOf(const FragmentSet& set, const Bake& bake, const FragmentPath& parent) {
    FragmentSelection selection{.parent = parent};
    const std::vector<std::optional<SeedId>> seeds = seedsOfFragments(bake, parent);
    for (std::uint32_t k = 0; k < set.size(); ++k) {
        if (!set[k]) continue;
        if (!seeds[k]) return selectionOf(set, bake);
        selection.seeds.insert(*seeds[k]);
    }
    if (selection.isEmpty()) return {};
    if (fragmentsOf(selection, bake) == set) return selection;
    selection.ids.emplace();
    for (std::uint32_t k = 0; k < set.size(); ++k) {
        if (set[k]) selection.ids->insert(bake.fragmentId(k));
    }
    return selection;
}

}  // namespace rubble
