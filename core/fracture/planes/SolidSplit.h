#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/planes/SectionPlane.h"
#include "core/fracture/solid/SolidPartition.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// A partition with a fragment split.
struct SolidSplit {
    SolidPartition partition;
    std::vector<std::uint32_t>
        pieces;  // the parts of the fragment, as numbered in the partition; one: nothing is split
    std::vector<std::uint32_t> numbers;  // the new number of each fragment; of the one that is split, its first part's
};

/// Splits a fragment by a plane into its parts on both sides; a side may have several. Neighbours get the points where
/// their common edges and faces are cut, so all fit together as before. Corners, edges and faces in the plane stay.
/// What is thinner than kInPlane, or a needle hardly thicker, stays with its neighbour.
///
/// The part with the smallest corner (x, then y, then z; the one below the plane of two that share it) keeps the part
/// number; if it has none, the parts are numbered from 0. The others get the next free part numbers of the seed.
/// O(partition).
///
/// Errors: BadInput for a fragment that does not exist or a plane that is not finite; Cancelled.
Result<SolidSplit> splitFragment(SolidPartition partition, std::uint32_t fragment, const SectionPlane& plane,
                                 const TaskContext& task = {});

}  // namespace rubble
