#pragma once

#include "core/asset/Bake.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace rubble {

/// Who touches whom among fragments of different parents. What is there when all is broken down to a level is its fragments, and
/// those above it that are not broken: of these, all pairs that lie on both sides of one cut and overlap there by more than bonds
/// ask for (Fragments::leastEdge). Each pair with the smaller number first, ascending; fragments that were made together are left out,
/// since their bonds tell of them.
///
/// Told by the cuts, not by distance: gaps between pieces change nothing. O(edges · edges of the fragments they are pieces of), and
/// for each edge of a cut the pieces on one side times those on the other.
std::vector<std::pair<std::uint32_t, std::uint32_t>> contactsAcrossParents(const Bake& bake, std::uint32_t level);

}  // namespace rubble
