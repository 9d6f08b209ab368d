#pragma once

#include "core/fracture/Partition.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rubble {

/// A vertex of the outline that touches an edge between cells without crossing it.
struct TouchingVertex {
    std::uint32_t point;
    std::uint32_t firstPiece;  // the pieces of the cell that it belongs to
    std::uint32_t lastPiece;
};

/// What is one point, or on one line, at the precision of the coordinates, and which points must stay as they are.
struct Coincidences {
    std::vector<std::array<std::uint32_t, 2>> pairs;
    std::vector<TouchingVertex> touches;
    std::uint32_t keptBegin = 0;  // the outline's own vertices: [keptBegin, keptEnd)
    std::uint32_t keptEnd = 0;
    double distance = 0.0;  // m; nearer points are one
};

/// Joins coincident points and takes away what collapses with them: edges without length, spikes without width, pieces
/// without area. What lay on either side of them becomes neighbours, so that the pieces stay one planar subdivision and
/// nothing is lost but the width below the precision. Where a piece's ring meets itself in a point it is parted there.
void joinCoincidences(Partition& partition, Coincidences coincidences);

}  // namespace rubble
