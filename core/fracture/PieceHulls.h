#pragma once

#include "core/geometry/Polytope.h"

#include <vector>

namespace rubble {

/// What a hull may leave out of a piece, in m.
struct HullTolerance {
    double thinnest = 0.0;  // narrower parts have no hull: see widthOf
    double flat = 0.0;      // a corner may turn right by this distance from its neighbours' line
};

/// Convex hulls that fill a piece extruded to z in [-depth/2, depth/2], up to the tolerance: one where it is convex,
/// else one a convex part. Their corners are the piece's. None where every part is too thin.
std::vector<Polytope> hullsOfPiece(const Polygon& piece, double depth, const HullTolerance& tolerance);

}  // namespace rubble
