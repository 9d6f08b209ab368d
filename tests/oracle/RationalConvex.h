#pragma once

#include "core/geometry/predicates/Vec.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <cstdint>
#include <vector>

namespace rubble::oracle {

using Exact = CGAL::Exact_predicates_exact_constructions_kernel;         // lazy rational numbers
using Predicates = CGAL::Exact_predicates_inexact_constructions_kernel;  // for points of the input only
using Point = Exact::Point_2;
using Line = Exact::Line_2;

/// A straight side of a convex region, which lies to the left of its line.
struct Side {
    Line line;
    std::uint32_t name;  // of the half-plane that it comes from
    static constexpr std::uint32_t kUnnamed = 0xffffffffu;
};

/// A convex region, counter-clockwise: sides[k] runs from corners[k] to the next. Each corner is an input point or an
/// intersection of two input lines, so that the exact numbers stay short after any number of clips.
struct Convex {
    std::vector<Point> corners;
    std::vector<Side> sides;

    bool isEmpty() const { return corners.empty(); }
    const Point& end(std::size_t side) const { return corners[(side + 1) % corners.size()]; }
    bool liesOn(std::size_t side, const Line& line) const;
    double lengthOf(std::size_t side) const;
    CGAL::Bbox_2 box() const;
};

/// The part of the region to the left of a side; empty if it has no area. A side of the region that lies on the cut
/// keeps its name.
Convex clipped(const Convex& region, const Side& cut);

double areaOf(const Convex& region);
double perimeterOf(const Convex& region);
/// The integral of (position - origin) over the region.
Vec2 momentOf(const Convex& region, const Point& origin);

}  // namespace rubble::oracle
