#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/delaunay/Delaunay.h"
#include "core/fracture/partition/Partition.h"
#include "core/geometry/polygon/NarrowFeatures.h"

#include <span>

namespace rubble {

/// The minimum shared length of neighbouring pieces, relative to the outline's diameter.
inline constexpr double kMinSharedEdge = kVisibleFraction;

/// The Voronoi cells of the seeds, clipped to the outline, which must be validated(). Seeds may lie outside; without
/// seeds the outline is one piece without a seed. Every sign is exact, ties go to the lower seed index; points are
/// rounded once. Points closer than kWeldFraction (LocalFrame.h) of the outline's bounding radius are welded; a
/// validated outline is farther than that from itself, except in acute corners (AcuteCorners.h).
///
/// Errors: those of triangulate() and traceOutline(); Cancelled.
Result<Partition> voronoiPartition(const Polygon& outline, const Delaunay& delaunay, const TaskContext& task = {});
Result<Partition> voronoiPartition(const Polygon& outline, std::span<const Vec2> seeds, const TaskContext& task = {});

}  // namespace rubble
