#pragma once

#include "bench/Cells.h"

#include <span>

namespace rubble::bench {

/// All cells of the seeds in the unit square by CGAL: Delaunay_triangulation_2 on exact predicates and inexact
/// constructions, the seeds inserted at once (in spatial order), then its dual.
Cells cellsByCgal(std::span<const Vec2> seeds);

/// Only what comes before the clipping: the triangulation and the Voronoi corner of every triangle. Gives the number of
/// corners.
std::size_t dualByCgal(std::span<const Vec2> seeds);

/// The same cells by Boost.Polygon, whose sweep wants integers: the square is 2^30 units wide there.
Cells cellsByBoost(std::span<const Vec2> seeds);

}  // namespace rubble::bench
