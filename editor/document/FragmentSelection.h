#pragma once

#include "core/asset/bake/FragmentSets.h"

#include <optional>
#include <set>
#include <string>

namespace rubble {

/// Selected or hidden fragments of the active asset, named so that the names survive a new bake: all fragments that
/// come from some seeds of one pattern, or a subset of those.
struct FragmentSelection {
    using Seeds = std::set<SeedId>;
    using Ids = std::set<std::string>;

    Seeds seeds;               // every fragment comes from one of these
    std::optional<Ids> ids;    // the subset, see Bake::fragmentId; none: all fragments of the seeds
    FragmentPath parent = {};  // the fragment that the seeds fracture; empty: the whole asset

    bool isEmpty() const { return seeds.empty(); }
    /// Whether the fragment `id`, which comes from `seed` of the pattern of `fragment`, is selected.
    bool contains(const FragmentPath& fragment, SeedId seed, const std::string& id) const;
    /// The seeds of the pattern of `fragment` that selected fragments come from, as far as the names tell: none if an
    /// ancestor's seeds select all of `fragment` at once.
    Seeds seedsOf(const FragmentPath& fragment) const;
    bool operator==(const FragmentSelection&) const = default;
};

/// The selected fragments of a bake. O(fragments · log seeds).
FragmentSet fragmentsOf(const FragmentSelection& selection, const Bake& bake);

/// The selection of a set of fragments: by seeds alone if the set contains all fragments of these. The seeds are those
/// of `parent` if the whole set lies inside it, otherwise those of the whole asset.
FragmentSelection selectionOf(const FragmentSet& set, const Bake& bake, const FragmentPath& parent = {});

}  // namespace rubble
