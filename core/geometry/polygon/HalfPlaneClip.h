#pragma once

#include "core/geometry/polygon/Polygon.h"

#include <span>

namespace rubble {

/// The points x with normal · x <= offset.
struct HalfPlane {
    Vec2 normal;  // any nonzero length
    double offset = 0.0;
};

/// The half-plane of the points that are at least as near to `site` as to `other`.
HalfPlane nearerTo(Vec2 site, Vec2 other);

/// Clips a convex counter-clockwise ring by a half-plane. Overwrites `clipped`, whose memory is reused; empty if the
/// interiors do not intersect. Corners on the half-plane's boundary are kept.
/// Source: Sutherland, Hodgman 1974.
void clipByHalfPlane(std::span<const Vec2> convex, const HalfPlane& halfPlane, Ring& clipped);

}  // namespace rubble
