#pragma once

#include "core/geometry/Vec.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rubble::oracle {

/// Holds a list of triangles of input indices against CGAL: as many as CGAL's Delaunay triangulation has; each
/// counter-clockwise with an empty circumcircle; where more than three distinct seeds lie on that circle, the lowest
/// index of them is a corner. Says what is wrong first, or nothing. Quadratic in the seeds.
std::optional<std::string> delaunayFault(std::span<const std::array<std::uint32_t, 3>> triangles,
                                         std::span<const Vec2> seeds);

}  // namespace rubble::oracle
