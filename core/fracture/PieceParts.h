#pragma once

#include "core/geometry/ConvexParts.h"
#include "core/geometry/Predicates.h"

#include <cmath>
#include <optional>
#include <span>

namespace rubble {

/// What the hulls of a piece may leave out, in m.
struct HullTolerance {
    double thinnest = 0.0;  // narrower parts have no hull: see widthOf
    double flat = 0.0;      // a corner may turn right by this distance from its neighbours' line
};

/// Whether a ring of at least three corners turns left at every one, so clearly that rounding cannot have made it so. Inline,
/// as a bake asks it of every piece, and nearly all do.
inline bool turnsLeft(std::span<const Vec2> ring) {
    Vec2 corner = ring.back(), in = corner - ring[ring.size() - 2];
    bool isLeft = true;
    for (const Vec2 after : ring) {
        const Vec2 out = after - corner;
        const double left = in.x * out.y, right = in.y * out.x;
        isLeft &= left - right > kOrientBound * (std::abs(left) + std::abs(right));
        corner = after;
        in = out;
    }
    return isLeft;
}

/// The convex parts of a piece that hulls can stand on, corners numbered as by convexParts(): none where the piece is
/// convex itself, up to the tolerance. Nothing where every part is too thin.
std::optional<IndexLoops> hullParts(const Polygon& piece, const HullTolerance& tolerance);

}  // namespace rubble
