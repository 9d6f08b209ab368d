#pragma once

#include "core/geometry/polygon/Polygon.h"

#include <cstdint>
#include <string>
#include <vector>

namespace rubble::oracle {

/// A generated input of the fracture core; its number determines it.
struct FractureCase {
    std::uint64_t number = 0;
    std::string family;  // "comb, lattice seeds"
    Polygon outline;     // valid, canonical
    std::vector<Vec2> seeds;
};

/// The case with a number. Numbers cycle through all combinations of outlines (rectangles, slivers, stars, combs, L,
/// lattices, 1,000 corners, points on straight sides, up to three holes, far from the origin) and seeds (uniform,
/// integer lattice, grid, collinear, few, duplicates, 1 ulp apart, on the outline, outside).
FractureCase fractureCase(std::uint64_t number);

/// The case as JSON for `rubble-cli fracture`, with all digits.
std::string jsonOf(const FractureCase& fractureCase);

}  // namespace rubble::oracle
