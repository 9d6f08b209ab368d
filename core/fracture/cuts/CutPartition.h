#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/cuts/CutSet.h"
#include "core/fracture/partition/Partition.h"
#include "core/geometry/polygon/Polygon.h"

namespace rubble {

/// Cuts the pieces of a partition along straight cuts. The result is one planar subdivision again; the outline's own
/// points, and pieces that are not near a cut, do not change. Pieces keep their seed and get their cells in cut layers.
///
/// A stretch of a cut that separates nothing, because it ends within a piece or goes only part of the way around a
/// hole, is left out and reported (LooseCut, at its layer and the index of its line; the value is its length). A seed
/// whose last piece vanishes by rounding is reported (SeedWithoutCell). Points are rounded once. O(n log n) for cuts
/// that intersect few others.
///
/// Errors: Degenerate if cuts cannot be distinguished; Limit above kMaxIntersections; Cancelled.
Result<Partition> cutApart(Partition partition, const Polygon& outline, const CutSet& cuts,
                           const TaskContext& task = {});

}  // namespace rubble
