#pragma once

#include "core/geometry/search/Box3.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble::oracle {

/// A Voronoi cell in a box, by voro++.
struct BoxCell {
    double volume = 0.0;                    // m³
    std::vector<std::uint32_t> neighbours;  // seeds, ascending
    std::vector<double> areas;              // m², of the face with each
};

/// The cells of distinct seeds in a box, in doubles: one for each seed.
/// Source: Rycroft, VORO++: A three-dimensional Voronoi cell library in C++, 2009.
std::vector<BoxCell> boxCells(const Box3& box, std::span<const Vec3> seeds);

}  // namespace rubble::oracle
