#pragma once

#include "core/geometry/Polygon.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace rubble::oracle {

/// What exact arithmetic says about the part of a seed's cell that lies inside an outline. The numbers are rounded
/// at the very end: their relative error is below 1e-12.
struct ExactCell {
    double area = 0.0;             // m^2; 0: no cell
    Vec2 centroid{0.0, 0.0};       // m, relative to the outline's first corner
    double perimeter = 0.0;        // m, at least that of the cell's boundary
    std::uint32_t sameAs = kSelf;  // lower index of an equal seed, which has the cell instead
    /// The number of pieces; the two differ only where a piece or a neck between two is thinner than a hair.
    std::uint32_t fewestPieces = 0;
    std::uint32_t mostPieces = 0;
    std::vector<std::pair<std::uint32_t, double>> shared;  // {seed, m of common edge}, ascending seed, length > 0

    static constexpr std::uint32_t kSelf = 0xffffffffu;
};

/// The Voronoi cells of the seeds inside a valid outline, one a seed. Shares no code and no formula with core/: the
/// outline is cut into triangles, each cell is the intersection of half-planes, all in the lazy rational numbers of
/// CGAL; the part of a cell in a triangle is convex, so that areas add up and pieces are found by joining
/// parts across the triangles' common edges.
///
/// `hair` is a width in metres below which a piece or a neck may be lost to rounding.
std::vector<ExactCell> exactCells(const Polygon& outline, std::span<const Vec2> seeds, double hair);

}  // namespace rubble::oracle
