#pragma once

#include "core/fracture/partition/Partition.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rubble {

/// A vertex of the outline that lies on an edge between cells without crossing it.
struct TouchingVertex {
    std::uint32_t point;
    std::uint32_t firstPiece;  // of the cell that it belongs to
    std::uint32_t lastPiece;
};

/// Points that coincide, or lie on an edge, within the weld distance, and the points that must not move.
struct Coincidences {
    std::vector<std::array<std::uint32_t, 2>> pairs;
    std::vector<TouchingVertex> touches;
    std::uint32_t fixedBegin = 0;  // the outline's own vertices: [fixedBegin, fixedEnd)
    std::uint32_t fixedEnd = 0;
    double weldDistance = 0.0;  // m
};

/// Welds coincident points and removes degenerate elements: edges of zero length, spikes of zero width, pieces of zero
/// area. The pieces on either side of them become neighbours, so that the partition stays one planar subdivision and
/// loses no more than the weld distance. A ring that touches itself at a point is split there. O(n log n) in the
/// corners for each of the few edges that are removed or split in a piece.
///
/// Returns the number of edges visited, a measure of its work that does not depend on the machine.
std::size_t weldVertices(Partition& partition, Coincidences coincidences);

}  // namespace rubble
