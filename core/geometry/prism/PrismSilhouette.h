#pragma once

#include "core/geometry/prism/AxisView.h"

namespace rubble {

/// The boundary rings of the projection of a mesh along a view's z, in the frame's xy plane: outer ones
/// counter-clockwise, holes clockwise. Corners are rounded to 2^-24 of the silhouette's size.
/// Source: the Clipper library (Johnson).
std::vector<Ring> silhouetteRings(const AxisView& view, const TriangleMesh& mesh);

}  // namespace rubble
