#pragma once

#include "core/fracture/CutSet.h"
#include "core/fracture/Partition.h"

namespace rubble {

/// A partition whose pieces are cut apart along straight cuts: again one planar subdivision, with the outline's own points and all
/// that no cut comes near as they were. Pieces keep their seed, and get the names of the cells that cut layers put them into.
///
/// A stretch of a cut that parts nothing, since it ends within a piece or goes only part of the way around a hole, is left out and
/// reported (LooseCut, `seed`: the line, `of`: the layer, `amount`: its length). A seed whose last piece goes with rounding is
/// reported (SeedWithoutCell). Points are rounded once; the whole is O(n log n) for cuts that meet few others.
///
/// Errors: Degenerate where cuts cannot be told apart; Cancelled.
Result<Partition> cutApart(Partition partition, const Polygon& outline, const CutSet& cuts,
                           const TaskContext& task = {});

}  // namespace rubble
