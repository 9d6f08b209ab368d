#pragma once

#include "core/asset/Bake.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// Some of a bake's fragments: one mark a fragment. All functions take and give sets of the same bake, in time linear in
/// fragments and bonds.
using FragmentSet = std::vector<bool>;

FragmentSet allFragments(const Bake& bake);
/// Those that are not broken again: what stands there when everything has broken.
FragmentSet smallestFragments(const Bake& bake);
/// Those of one level; 0: the pieces of the whole.
FragmentSet fragmentsOfLevel(const Bake& bake, std::uint32_t level);
/// How many levels there are.
std::uint32_t levelCount(const Bake& bake);

/// With all pieces of what is in the set, at any depth.
FragmentSet withPieces(const Bake& bake, const FragmentSet& set);
/// The same, and with every fragment all of whose pieces are in it: the set as space that is filled.
FragmentSet completed(const Bake& bake, const FragmentSet& set);
/// The smallest fragments that are neither in the set nor pieces of what is.
FragmentSet invertedFragments(const Bake& bake, const FragmentSet& set);

/// With those that touch them: of their own level, whatever they are pieces of, or above it where what they touch is not broken as
/// deep. Of several levels in more than linear time, see contactsAcrossParents().
FragmentSet withNeighbours(const Bake& bake, const FragmentSet& set);
/// All that were made with them, themselves included.
FragmentSet siblingsOf(const Bake& bake, const FragmentSet& set);
/// What they are pieces of; pieces of the whole have none.
FragmentSet parentsOf(const Bake& bake, const FragmentSet& set);
/// What they are broken into; smallest ones have none.
FragmentSet childrenOf(const Bake& bake, const FragmentSet& set);

/// The smallest fragments with a volume in [least, most], m^3.
FragmentSet fragmentsOfVolume(const Bake& bake, double least, double most);
/// A share in [0, 1] of the smallest fragments, rounded to a whole number of them; another random seed, others. The
/// greater share holds the smaller one of the same random seed.
FragmentSet randomFragments(const Bake& bake, double share, std::uint64_t randomSeed);

}  // namespace rubble
