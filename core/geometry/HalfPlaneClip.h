#pragma once

#include "core/geometry/Polygon.h"

#include <span>

namespace rubble {

/// The points x with normal · x <= offset.
struct HalfPlane {
    Vec2 normal;  // any length but zero
    double offset = 0.0;
};

/// The half-plane of points at least as near to `site` as to `other`.
HalfPlane nearerTo(Vec2 site, Vec2 other);

/// Writes the part of a convex counter-clockwise ring that lies in the half-plane to `clipped` (cleared
/// first; its memory is reused); empty where nothing is left. Corners on the boundary stay.
/// Source: Sutherland, Hodgman 1974.
void clipByHalfPlane(std::span<const Vec2> convex, const HalfPlane& halfPlane, Ring& clipped);

}  // namespace rubble
