#pragma once

#include "core/geometry/Polygon.h"

#include <cstdint>
#include <string>
#include <vector>

namespace rubble::oracle {

/// An input of the fracture core, and where it comes from: the same number makes the same case.
struct FractureCase {
    std::uint64_t number = 0;
    std::string family;  // "comb, lattice seeds"
    Polygon outline;     // valid, canonical
    std::vector<Vec2> seeds;
};

/// The case with a number. Numbers go round all kinds of outlines (rectangles, slivers, stars, combs, L, cells of a
/// lattice, 1,000 corners, points on straight sides, up to three holes, far from the origin) and, crosswise, all kinds
/// of seeds (uniform, integer lattice, grid, collinear, few, duplicates, 1 unit apart, on the outline, outside).
FractureCase fractureCase(std::uint64_t number);

/// The case as the JSON that `rubble-cli fracture` reads, every digit kept.
std::string jsonOf(const FractureCase& fractureCase);

}  // namespace rubble::oracle
