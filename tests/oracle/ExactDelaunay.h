#pragma once

#include "core/geometry/predicates/Vec.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rubble::oracle {

/// Compares triangles of seed indices with CGAL: their number is that of CGAL's Delaunay triangulation; each is
/// counter-clockwise with an empty circumcircle; of more than three distinct seeds on that circle the lowest index is a
/// corner. Returns the first fault, or nothing. Quadratic in the seeds.
std::optional<std::string> delaunayFault(std::span<const std::array<std::uint32_t, 3>> triangles,
                                         std::span<const Vec2> seeds);

}  // namespace rubble::oracle
