#pragma once

#include "core/fracture/partition/VertexWelding.h"
#include "core/fracture/voronoi/AcuteCorners.h"
#include "core/fracture/voronoi/CellClipper.h"
#include "core/fracture/voronoi/PartitionPoints.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// The inputs of assembleCells().
struct CellSources {
    const Polygon& outline;
    const Delaunay& delaunay;
    const std::vector<std::uint32_t>& outgoing;
    const OutlineTrace& trace;
    const PointNumbers& numbers;
    const LocalFrame& frame;
    const AcuteCorners& acuteCorners;
    std::span<const Vec2> points;
};

/// The cells of consecutive sites, clipped to the outline. Neighbours are sites.
struct CellRange {
    std::uint32_t firstSite = 0;
    CellPieces pieces;
    std::vector<std::uint32_t> firstPieces;                // of each site, and one more at the end
    std::vector<std::array<std::uint32_t, 2>> coincident;  // points
    std::vector<TouchingVertex> touches;                   // with pieces numbered within this range
};

/// The cells of sites [firstSite, endSite).
CellRange assembleCells(const CellSources& sources, std::uint32_t firstSite, std::uint32_t endSite);

}  // namespace rubble
