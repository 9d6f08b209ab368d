#pragma once

#include "core/geometry/AxisView.h"

namespace rubble {

/// The rings around the shadow that a mesh throws along a view's z, in the frame's xy plane: outer ones counter-clockwise,
/// holes clockwise. Corners are rounded to 2^-24 of the shadow's size.
/// Source: the union of polygons is Clipper's.
std::vector<Ring> silhouetteRings(const AxisView& view, const TriangleMesh& mesh);

}  // namespace rubble
