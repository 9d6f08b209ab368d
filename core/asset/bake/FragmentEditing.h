#pragma once

#include "core/asset/project/Shaping.h"
#include "core/fracture/partition/Partition.h"

#include <vector>

namespace rubble {

/// Applies the edits whose parent is `parent` to the pieces of its fracture, whose origin is `offset` in the prism's
/// frame. Reports LostPiece where a piece is missing, is not connected to the one it is merged into, or does not
/// intersect its split line.
Partition editedPieces(Partition partition, const Seeds& seeds, const std::vector<FragmentEdit>& edits,
                       const FragmentPath& parent, Vec2 offset);

}  // namespace rubble
