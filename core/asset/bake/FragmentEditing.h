#pragma once

#include "core/asset/project/Shaping.h"

#include <vector>

namespace rubble {

/// Applies the edits whose parent is `parent` to the pieces of its fracture, whose frame stands at `offset` in the
/// prism's. Reports LostPiece where a piece is missing, is not connected to the one it is merged into, or is missed by
/// its line.
Partition editedPieces(Partition partition, const Seeds& seeds, const std::vector<FragmentEdit>& edits,
                       const FragmentPath& parent, Vec2 offset);

}  // namespace rubble
