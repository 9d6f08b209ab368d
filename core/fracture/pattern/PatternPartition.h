#pragma once

#include "core/fracture/delaunay/Delaunay.h"
#include "core/fracture/partition/Partition.h"
#include "core/fracture/pattern/Pattern.h"

namespace rubble {

/// The results of all stages of a pattern on an outline.
struct PatternStages {
    Seeds seeds;
    Delaunay delaunay;
    Partition partition;
};

/// A triangulation and the partition that follows from it.
struct TriangulatedPartition {
    Delaunay delaunay;
    Partition partition;
};

/// The Voronoi cells of seeds on a validated() outline. If the pattern has grain layers, the metric is anisotropic, and
/// the triangulation is that of the mapped seeds.
///
/// Errors: those of triangulate() and voronoiPartition().
Result<TriangulatedPartition> cellsOf(const Pattern& pattern, std::span<const Vec2> seeds, const Polygon& outline,
                                      const TaskContext& task = {});

/// The same cells, cut by the pattern's cuts.
///
/// Errors: those of cellsOf(), cutsOf() and cutApart().
Result<TriangulatedPartition> partitionOf(const Pattern& pattern, std::span<const Vec2> seeds, const Polygon& outline,
                                          const TaskContext& task = {});

/// Evaluates a pattern on a validated() outline: seeds, triangulation, cells and cuts.
///
/// Errors: those of seedsOf() and partitionOf().
Result<PatternStages> patternStages(const Pattern& pattern, const Polygon& outline, const TaskContext& task = {});

/// The id by which a piece is selected: that of its seed; without seeds, of its cell in the first cut layer; 0.0
/// without both.
SeedId cellId(const Partition& partition, std::uint32_t piece, std::span<const SeedId> seeds);

/// The name of a piece's cell: the ids of its seed and of its cells in cut layers; "0.0" without both.
std::string cellName(const Partition& partition, std::uint32_t piece, std::span<const SeedId> seeds);

/// The name of a piece in an asset or a fragment: the ids of its seed and of its cells in cut layers, "5.17+8.2", and a
/// number if several pieces have these, "5.17.1" (see partOfCell); "0.0" for an outline without seeds and cuts.
std::string pieceName(const Partition& partition, std::uint32_t piece, std::span<const SeedId> seeds);

}  // namespace rubble
