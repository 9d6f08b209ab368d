#pragma once

#include "core/geometry/hull/Polytope.h"

#include <vector>

namespace rubble::test {

// Hulls of bodies about the origin. Flat ones lie in the plane y = 0, from -height / 2 to height / 2.

/// A quarter rotation about x of a prism over a convex counter-clockwise ring in the plane x, y: it lies, its height
/// along y.
Polytope lyingPrism(const std::vector<Vec2>& ring, double height);

/// A square window frame of four beams.
std::vector<Polytope> frameHulls(double width, double beam, double height);
/// A ring of `sections` prisms.
std::vector<Polytope> ringHulls(double outerRadius, double innerRadius, double height, int sections);
/// A hub of 2 `teeth` sides with a tooth on every other.
std::vector<Polytope> gearHulls(double radius, double toothLength, double height, int teeth);
/// The letters E, U and L, and a plus sign, of rectangles that do not overlap, a fifth of the width thick.
std::vector<Polytope> eHulls(double width, double height);
std::vector<Polytope> uHulls(double width, double height);
std::vector<Polytope> lHulls(double width, double height);
std::vector<Polytope> crossHulls(double width, double height);

/// A regular prism.
Polytope discHull(double radius, double height, int corners);
/// A double pyramid over a square of width `width`, its tips on the x-axis.
Polytope needleHull(double length, double width);
/// A regular tetrahedron.
Polytope tetrahedronHull(double edge);

}  // namespace rubble::test
