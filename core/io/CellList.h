#pragma once

#include "core/fracture/Partition.h"
#include "core/fracture/ThesisMethod.h"
#include "core/geometry/Polygon.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// What is told of one seed's cell, in the input's coordinates.
struct Cell {
    std::uint32_t seed = 0;
    double area = 0.0;  // m^2
    Vec2 centroid{0.0, 0.0};
    std::vector<Polygon> pieces;
    std::vector<std::uint32_t> neighbours;  // seeds, ascending
};

/// The cells of a partition in seed order, one for every seed that has one. Neighbours share more than `least` (m).
std::vector<Cell> cellList(const Partition& partition, double least);

/// The same of the thesis's diagram, whose cells have one piece and are neighbours where a triangle joins them. Cells with
/// fewer than three corners, or with one that is not finite, are none.
std::vector<Cell> cellList(const ThesisDiagram& diagram);

}  // namespace rubble
