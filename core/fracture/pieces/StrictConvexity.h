#pragma once

#include "core/geometry/predicates/Predicates.h"

#include <cmath>
#include <span>

namespace rubble {

/// Whether a ring of at least three corners turns left at every corner by more than rounding errors. Inline, because it
/// is computed for every piece.
inline bool isStrictlyConvex(std::span<const Vec2> ring) {
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
