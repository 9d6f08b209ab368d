#pragma once

#include "core/geometry/Polygon.h"

namespace rubble {

/// Where an edge lies along an outline.
struct OutlineStretch {
    double from = 0.0;      // m of the ring's length where the edge begins, growing the way the edge runs
    double to = 0.0;        // m
    double distance = 0.0;  // m between the edge's middle and the outline
};

/// The stretch of the outline's edge (of any ring) that is nearest to the middle of the edge from `a` to `b`. Each
/// ring's length begins at its first corner. Linear in the corners.
OutlineStretch outlineStretch(const Polygon& outline, Vec2 a, Vec2 b);

}  // namespace rubble
