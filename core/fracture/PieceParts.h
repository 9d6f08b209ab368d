#pragma once

#include "core/geometry/ConvexParts.h"

#include <optional>

namespace rubble {

/// What the hulls of a piece may leave out, in m.
struct HullTolerance {
    double thinnest = 0.0;  // narrower parts have no hull: see widthOf
    double flat = 0.0;      // a corner may turn right by this distance from its neighbours' line
};

/// The convex parts of a piece that hulls can stand on, corners numbered as by convexParts(): none where the piece is
/// convex itself, up to the tolerance. Nothing where every part is too thin.
std::optional<IndexLoops> hullParts(const Polygon& piece, const HullTolerance& tolerance);

}  // namespace rubble
