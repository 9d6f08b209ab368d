#pragma once

#include "core/geometry/predicates/Vec.h"

#include <array>
#include <span>
#include <vector>

namespace rubble {

/// An axis-aligned box; empty (min > max) until a point is included.
struct Box3 {
    Vec3 min{1e308, 1e308, 1e308};
    Vec3 max{-1e308, -1e308, -1e308};
    void include(Vec3 point);
    void include(const Box3& box);
    bool isEmpty() const { return min.x > max.x; }
    Vec3 corner(int index) const;  // index in [0, 8)
    double diagonal() const;
    Vec3 centre() const { return min + (max - min) / 2.0; }
    bool operator==(const Box3&) const = default;
};

/// The box of a segment in the plane, with z = 0.
Box3 boxOf(Vec2 from, Vec2 to);
/// The boxes of edges.
std::vector<Box3> boxesOf(std::span<const std::array<Vec2, 2>> edges);

}  // namespace rubble
