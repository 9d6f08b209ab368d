#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/Delaunay.h"
#include "core/fracture/Partition.h"
#include "core/geometry/NarrowPlaces.h"

#include <span>

namespace rubble {

/// Two edges of a pattern touch where they share at least this much of the outline's diameter.
inline constexpr double kLeastSharedEdge = kVisiblePart;

/// The outline cut into the Voronoi cells of the seeds. The outline must be validated(). Seeds anywhere compete; no
/// seeds at all give one piece without a seed. Every sign is exact, ties go to the lower seed index; points are
/// rounded once. Points nearer than kJoinedPart (PointFrame.h) of the outline's reach are one; a validated outline keeps
/// farther from itself than that, but for the tips of sharp corners (OutlineTips.h).
///
/// Errors: those of triangulate(); Cancelled.
Result<Partition> voronoiPartition(const Polygon& outline, const Delaunay& delaunay, const TaskContext& task = {});
Result<Partition> voronoiPartition(const Polygon& outline, std::span<const Vec2> seeds, const TaskContext& task = {});

}  // namespace rubble
