#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/Partition.h"

#include <vector>

namespace rubble {

/// A corner of a shrunk piece: its place, and the piece that was behind the edge it begins; kNone: the outline.
struct ShrunkCorner {
    Vec2 place;
    std::uint32_t across;
};
using ShrunkRing = std::vector<ShrunkCorner>;

/// What a gap leaves of a piece.
struct ShrunkPiece {
    std::vector<ShrunkRing> rings;  // the outer one first; none where nothing is left
    bool isCutApart = false;        // the largest part is what is left
};

/// A piece without what is nearer than `margin` metres to its cut edges, those with a piece behind them. Corners between cut
/// edges are mitred (cut off beyond a right angle); along the outline nothing is taken away but the ends beside cut edges. What
/// the margin cuts apart keeps its largest part.
ShrunkPiece shrunkPiece(const Partition& partition, std::uint32_t piece, double margin);

/// All pieces shrunk, with their numbers and names; of those that are gone no rings are left. Points are not shared any more, and
/// `across` names whom a piece touches without the gap. Reported is VanishedPiece, for each piece that is gone or cut apart.
///
/// Errors: Cancelled.
Result<Partition> shrunkPartition(const Partition& partition, double margin, const TaskContext& task = {});

/// The sentence that tells the user that a piece is gone, and `lost` m^2 with it.
Report vanishedReport(const Partition& partition, std::uint32_t piece, double lost);

}  // namespace rubble
