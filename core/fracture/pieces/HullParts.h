#pragma once

#include "core/geometry/polygon/ConvexParts.h"

#include <optional>

namespace rubble {

/// The tolerances for omitting details from the hulls of a piece, in m.
struct HullTolerance {
    double minWidth = 0.0;  // narrower parts have no hull, see widthOf
    double flatness = 0.0;  // distance of a reflex corner from the line of its neighbours that counts as convex
};

/// The convex parts of a piece that are wide enough for hulls, with corners numbered as by convexParts(): empty if the
/// piece itself is convex, within the tolerance. Nothing if every part is too thin.
std::optional<IndexLoops> hullParts(const Polygon& piece, const HullTolerance& tolerance);

}  // namespace rubble
