#pragma once

#include "core/fracture/OutlineTips.h"
#include "core/fracture/PartitionPoints.h"
#include "core/fracture/PartitionRepair.h"
#include "core/fracture/VisitedCell.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// All that cells are put together from.
struct CellSources {
    const Polygon& outline;
    const Delaunay& delaunay;
    const std::vector<std::uint32_t>& outgoing;
    const OutlineTrace& trace;
    const PointNumbers& numbers;
    const PointFrame& frame;
    const OutlineTips& tips;
    std::span<const Vec2> points;
};

/// The cells of consecutive sites, clipped to the outline. `across` names sites.
struct CellStretch {
    std::uint32_t firstSite = 0;
    CellPieces pieces;
    std::vector<std::uint32_t> firstPieces;                // of each site in `pieces`, and one more at the end
    std::vector<std::array<std::uint32_t, 2>> coincident;  // points
    std::vector<TouchingVertex> touches;                   // by pieces of this stretch
};

/// Puts the cells of sites [firstSite, endSite) together.
CellStretch assembledCells(const CellSources& sources, std::uint32_t firstSite, std::uint32_t endSite);

}  // namespace rubble
