#pragma once

#include "core/geometry/hull/Polytope.h"

namespace rubble {

/// Merges neighbouring faces that lie within `tolerance` metres of a common plane, such as those of a hull of rounded
/// points: a box then stands on the four corners of one face, not on one of two triangles. Vertices left with fewer
/// than three faces are removed. All vertices stay behind every face's plane. Returns the polytope unchanged if a
/// merged face were not simple.
///
/// The tolerance must be small relative to the polytope's width.
Polytope mergeCoplanarFaces(const Polytope& polytope, double tolerance);

}  // namespace rubble
