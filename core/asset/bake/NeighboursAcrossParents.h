#pragma once

#include "core/asset/bake/Bake.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace rubble {

/// The pairs of neighbours with different parents among the fragments of a level and the leaves above it: those that
/// lie on both sides of one cut and overlap there by more than ExtrudedPieces::minSharedEdge, those of meshes by more
/// than kMinCommonArea. The smaller number comes first, pairs ascend. Siblings are left out: their bonds are known.
///
/// Found by cuts instead of distances, so that gaps between pieces do not matter. O(n log n) for n edges or triangles,
/// and the pairs found.
std::vector<std::pair<std::uint32_t, std::uint32_t>> neighboursAcrossParents(const Bake& bake, std::uint32_t level);

}  // namespace rubble
