#pragma once

#include "core/asset/FragmentSets.h"

#include <optional>
#include <set>
#include <string>

namespace rubble {

/// Fragments of the asset at hand that are chosen or hidden, by names that stay when it is baked again: all that come from
/// some seeds of its own pattern, or of these only some.
struct FragmentChoice {
    using Seeds = std::set<SeedId>;
    using Ids = std::set<std::string>;

    Seeds seeds;             // that all of them come from
    std::optional<Ids> ids;  // of these only, see Bake::fragmentId; none: of all that come from the seeds

    bool isEmpty() const { return seeds.empty(); }
    /// Whether a fragment that comes from a seed is named.
    bool holds(SeedId seed, const std::string& id) const { return seeds.contains(seed) && (!ids || ids->contains(id)); }
    bool operator==(const FragmentChoice&) const = default;
};

/// The fragments of a bake that a choice names. O(fragments · log seeds).
FragmentSet fragmentsOf(const FragmentChoice& choice, const Bake& bake);

/// The choice that names a set: by seeds alone where it holds all that come from them.
FragmentChoice choiceOf(const FragmentSet& set, const Bake& bake);

}  // namespace rubble
