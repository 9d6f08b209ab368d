#pragma once

#include "core/fracture/Delaunay.h"
#include "core/fracture/Partition.h"
#include "core/fracture/Pattern.h"

namespace rubble {

/// What a pattern makes of an outline, stage by stage.
struct PatternStages {
    Seeds seeds;
    Delaunay delaunay;
    Partition partition;
};

/// The same from given seeds on.
struct CutCells {
    Delaunay delaunay;
    Partition partition;
};

/// The cells of seeds on a validated() outline, in the pattern's grain if it has any. The triangulation is then that of the
/// mapped seeds.
///
/// Errors: those of triangulate(); Cancelled.
Result<CutCells> cellsOf(const Pattern& pattern, std::span<const Vec2> seeds, const Polygon& outline,
                         const TaskContext& task = {});

/// These cells cut apart by the pattern's cuts.
///
/// Errors: those of triangulate(), cutsOf() and cutApart(); Cancelled.
Result<CutCells> partitionOf(const Pattern& pattern, std::span<const Vec2> seeds, const Polygon& outline,
                             const TaskContext& task = {});

/// Carries out a whole recipe on a validated() outline: seeds, their triangulation and cells, and these cut apart.
///
/// Errors: those of seedsOf(), triangulate(), cutsOf() and cutApart(); Cancelled.
Result<PatternStages> partitionBy(const Pattern& pattern, const Polygon& outline, const TaskContext& task = {});

/// By what a piece is chosen: its seed's name, or that of the first cell a cut layer puts it into where there are no seeds.
SeedId cellId(const Partition& partition, std::uint32_t piece, std::span<const SeedId> seeds);

/// The name of the cell that a piece is, or is a part of: its seed's and those of the cells that cut layers put it into.
std::string cellName(const Partition& partition, std::uint32_t piece, std::span<const SeedId> seeds);

/// A piece's name in an asset or a fragment: its seed's and those of the cells that cut layers put it into, "5.17+8.2", and a
/// number where several are called that, "5.17.1" (see partOfCell); "0.0" for an outline that nothing names.
std::string pieceName(const Partition& partition, std::uint32_t piece, std::span<const SeedId> seeds);

}  // namespace rubble
