#pragma once

#include "core/fracture/partition/Partition.h"
#include "core/geometry/polygon/Polygon.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// The cell of a seed, in the input's coordinates.
struct Cell {
    std::uint32_t seed = 0;
    double area = 0.0;  // m²
    Vec2 centroid{0.0, 0.0};
    std::vector<Polygon> pieces;
    std::vector<std::uint32_t> neighbours;  // seeds, ascending
};

/// Returns the cells of a partition by seed; seeds without a cell are left out. Neighbours share edges longer than
/// `minSharedEdge` (m).
std::vector<Cell> cellList(const Partition& partition, double minSharedEdge);

}  // namespace rubble
