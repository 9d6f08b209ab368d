#pragma once

#include "core/fracture/Partition.h"

#include <optional>
#include <string>

namespace rubble {

/// What becomes of pieces below a size.
enum class SmallPieceRule {
    Keep,
    Merge,      // each goes into the neighbour with the longest shared edge
    DropSeeds,  // a seed whose cell is too small goes, and the cells around take its place; parts of others are merged
};

/// How the size of pieces is given.
enum class PieceMeasure {
    Area,         // m^2
    Volume,       // m^3
    PartOfMean,   // of the mean size of the pieces there are in the end
    PartOfWhole,  // of what is broken
};

/// Which pieces are too small, and what becomes of them.
struct SmallPieces {
    SmallPieceRule rule = SmallPieceRule::Keep;
    PieceMeasure measure = PieceMeasure::PartOfMean;
    double limit = 0.1;  // > 0; a part is at most 1
    bool operator==(const SmallPieces&) const = default;
};

/// Says in one sentence what is wrong with the limit, or nothing.
std::optional<std::string> verifySmallPieces(const SmallPieces& small);

/// The area, in m^2, that pieces must have, where there are `count` on `area` m^2, `depth` m deep.
double leastArea(const SmallPieces& small, double area, std::uint32_t count, double depth);

/// Merges pieces below the limit, the smallest first (the first of equals), into the neighbour with the longest shared edge,
/// until none is left or one piece is all there is. The receiver keeps its name and is reported with each piece that it took
/// (MergedPiece). The partition as it is where none is too small. O(corners + merged · log pieces), about.
Partition withoutSmallPieces(Partition partition, const SmallPieces& small, double depth);

/// The seeds to be dropped next for SmallPieceRule::DropSeeds: those whose cells, all parts together, are below the limit and
/// smaller (or of lower index) than each such cell that they touch. Ascending; dropped again and again it comes to an end.
std::vector<std::uint32_t> seedsToDrop(const Partition& partition, const SmallPieces& small, double depth);

}  // namespace rubble
