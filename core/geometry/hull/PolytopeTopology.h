#pragma once

#include "core/geometry/hull/Polytope.h"

#include <optional>

namespace rubble {

/// Returns the polytope with these vertices and faces: its edges in the order in which the faces run along them first,
/// each from its smaller vertex, and the planes of the faces by Newell's method. Nothing if a face has fewer than three
/// vertices, one that does not exist, or no area.
/// Source of the planes: Sutherland, Sproull, Schumacker, A Characterization of Ten Hidden-Surface Algorithms, 1974.
std::optional<Polytope> polytopeOf(std::vector<Vec3> vertices, std::vector<std::vector<std::uint32_t>> faces);

}  // namespace rubble
