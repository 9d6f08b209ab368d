#pragma once

#include "core/geometry/polygon/Polygon.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace rubble::oracle {

/// The part of a seed's cell inside an outline, in exact arithmetic. Only the results are rounded: their relative error
/// is below 1e-12.
struct ExactCell {
    double area = 0.0;             // m²; 0: no cell
    Vec2 centroid{0.0, 0.0};       // m, relative to the outline's first corner
    double perimeter = 0.0;        // m, an upper bound of the cell's
    std::uint32_t sameAs = kSelf;  // lower index of an equal seed, which has the cell instead
    /// Bounds of the number of pieces; they differ only if a piece or a neck is narrower than `hair`.
    std::uint32_t minPieces = 0;
    std::uint32_t maxPieces = 0;
    std::vector<std::pair<std::uint32_t, double>> shared;  // {seed, m of common edge > 0}, ascending

    static constexpr std::uint32_t kSelf = 0xffffffffu;
};

/// The Voronoi cells of the seeds inside a valid outline, one per seed. Shares no code and no formula with core/: the
/// outline is triangulated and each cell is an intersection of half-planes, in CGAL's lazy rational numbers; the part
/// of a cell in a triangle is convex, so that areas add up, and pieces are parts connected through the triangles'
/// common edges.
///
/// `hair`: the width, in m, below which a piece or a neck may be lost by rounding.
std::vector<ExactCell> exactCells(const Polygon& outline, std::span<const Vec2> seeds, double hair);

}  // namespace rubble::oracle
