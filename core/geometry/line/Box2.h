#pragma once

#include "core/geometry/predicates/Vec.h"

namespace rubble {

/// An axis-aligned box; empty (min > max) until a point is included.
struct Box2 {
    Vec2 min{1e308, 1e308};
    Vec2 max{-1e308, -1e308};
    void include(Vec2 point) {
        min = glm::min(min, point);
        max = glm::max(max, point);
    }
    Vec2 size() const { return max - min; }
    double diagonal() const { return min.x > max.x ? 0.0 : glm::length(size()); }
};

}  // namespace rubble
