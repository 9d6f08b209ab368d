#pragma once

#include <cstdint>
#include <vector>

namespace rubble {

struct Partition;

/// The handling of pieces below a minimum size.
enum class SmallPieceRule {
    Keep,
    Merge,      // into the neighbour with the longest shared edge
    DropSeeds,  // removes seeds with small cells, whose neighbours grow; small parts of other cells are merged
};

/// The measure of the minimum size.
enum class PieceMeasure {
    Area,             // m²
    Volume,           // m³
    FractionOfMean,   // of the mean size of the remaining pieces
    FractionOfWhole,  // of the whole
};

/// The minimum size of pieces, and the handling of smaller ones.
struct SmallPieces {
    SmallPieceRule rule = SmallPieceRule::Keep;
    PieceMeasure measure = PieceMeasure::FractionOfMean;
    double limit = 0.1;  // > 0; a fraction is at most 1
    bool operator==(const SmallPieces&) const = default;
};

/// The minimum area of pieces in m², for `count` pieces with a total of `area` m² and a depth of `depth` m.
double minPieceArea(const SmallPieces& small, double area, std::uint32_t count, double depth);

/// Merges pieces below the limit, the smallest first (ties go to the first), into the neighbour with the longest shared
/// edge, until none is too small or only one piece is left. The receiver keeps its name; each merged piece is reported
/// (MergedPiece). Returns the partition unchanged if none is too small. O(corners + merged · log pieces), expected.
Partition withoutSmallPieces(Partition partition, const SmallPieces& small, double depth);

/// The seeds to be dropped next for SmallPieceRule::DropSeeds: those whose cells (all parts together) are below the
/// limit and smaller than each such neighbour (or equal, with a lower index). Ascending. Dropping them repeatedly
/// terminates.
std::vector<std::uint32_t> seedsToDrop(const Partition& partition, const SmallPieces& small, double depth);

}  // namespace rubble
