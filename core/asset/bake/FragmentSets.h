#pragma once

#include "core/asset/bake/Bake.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// A set of fragments of a bake: one flag per fragment. All functions take and return sets of the same bake, in time
/// linear in fragments and bonds.
using FragmentSet = std::vector<bool>;

FragmentSet allFragments(const Bake& bake);
/// The fragments that are not fractured further.
FragmentSet leafFragments(const Bake& bake);
/// The fragments of one level; 0: those of the whole.
FragmentSet fragmentsOfLevel(const Bake& bake, std::uint32_t level);
/// The number of levels.
std::uint32_t levelCount(const Bake& bake);

/// The set and all descendants of its fragments.
FragmentSet withDescendants(const Bake& bake, const FragmentSet& set);
/// The same, and every fragment all of whose children are in it.
FragmentSet completed(const Bake& bake, const FragmentSet& set);
/// The fragments of the set that have no ancestor in it, ascending.
std::vector<std::uint32_t> rootsOf(const Bake& bake, const FragmentSet& set);
/// The leaves that are neither in the set nor descendants of it.
FragmentSet invertedFragments(const Bake& bake, const FragmentSet& set);

/// The set and its neighbours: of the same level, whatever their parents, and leaves above it. On several levels in
/// O(n log n): see neighboursAcrossParents().
FragmentSet withNeighbours(const Bake& bake, const FragmentSet& set);
/// All siblings, including the set itself.
FragmentSet siblingsOf(const Bake& bake, const FragmentSet& set);
/// The parents; fragments of the whole have none.
FragmentSet parentsOf(const Bake& bake, const FragmentSet& set);
/// The children; leaves have none.
FragmentSet childrenOf(const Bake& bake, const FragmentSet& set);

/// The leaves with a volume in [least, most], m³.
FragmentSet fragmentsOfVolume(const Bake& bake, double least, double most);
/// A random fraction, in [0, 1], of the leaves, rounded to a whole number of them. With the same random seed, a larger
/// fraction contains a smaller one.
FragmentSet randomFragments(const Bake& bake, double fraction, std::uint64_t randomSeed);

}  // namespace rubble
