#pragma once

#include "core/asset/FragmentSets.h"

#include <optional>
#include <set>
#include <string>

namespace rubble {

/// Fragments of the asset at hand that are chosen or hidden, by names that stay when it is baked again: all that come from
/// some seeds of one pattern, or of these only some.
struct FragmentChoice {
    using Seeds = std::set<SeedId>;
    using Ids = std::set<std::string>;

    Seeds seeds;               // that all of them come from
    std::optional<Ids> ids;    // of these only, see Bake::fragmentId; none: of all that come from the seeds
    FragmentPath inside = {};  // the fragment that the seeds break; empty: the whole

    bool isEmpty() const { return seeds.empty(); }
    /// Whether a fragment is named that comes from a seed of the pattern inside `of`.
    bool holds(const FragmentPath& of, SeedId seed, const std::string& id) const;
    /// The seeds of the pattern inside `of` that named fragments come from, as far as names tell: none where all that is inside is
    /// named at once.
    Seeds seedsInside(const FragmentPath& of) const;
    bool operator==(const FragmentChoice&) const = default;
};

/// The fragments of a bake that a choice names. O(fragments · log seeds).
FragmentSet fragmentsOf(const FragmentChoice& choice, const Bake& bake);

/// The choice that names a set: by seeds alone where it holds all that come from them; by those inside a fragment where all of it is
/// in there, else by those of the whole.
FragmentChoice choiceOf(const FragmentSet& set, const Bake& bake, const FragmentPath& inside = {});

}  // namespace rubble
