#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/partition/Partition.h"

#include <vector>

namespace rubble {

/// A corner of a shrunk piece: its position, and the piece behind the edge that starts there; kNone: the outline.
struct ShrunkCorner {
    Vec2 position;
    std::uint32_t neighbour;
};
using ShrunkRing = std::vector<ShrunkCorner>;

/// A piece less the gap around it.
struct ShrunkPiece {
    std::vector<ShrunkRing> rings;  // the outer one first; empty if nothing is left
    bool isDisconnected = false;    // only the largest part remains
};

/// A piece without all points closer than `margin` metres to its cut edges, which have a piece behind them. Corners
/// between cut edges are mitred (bevelled beyond a right angle); along the outline only the ends next to cut edges are
/// removed. Of a disconnected result the largest part remains.
ShrunkPiece shrunkPiece(const Partition& partition, std::uint32_t piece, double margin);

/// All pieces shrunk, with their numbers and names; vanished ones are empty, without rings. Points are not shared, and
/// neighbours are those without the gap. Reports VanishedPiece for each piece that vanishes or is disconnected.
///
/// Errors: Cancelled.
Result<Partition> shrunkPartition(const Partition& partition, double margin, const TaskContext& task = {});

/// The diagnostic of a piece that vanished, with `lost` m².
Diagnostic vanishedReport(const Partition& partition, std::uint32_t piece, double lost);

}  // namespace rubble
