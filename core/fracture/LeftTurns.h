#pragma once

#include "core/geometry/Predicates.h"

#include <cmath>
#include <span>

namespace rubble {

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

}  // namespace rubble
