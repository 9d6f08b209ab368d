#pragma once

#include "core/geometry/Polytope.h"

namespace rubble {

/// The polytope with faces that lie within `tolerance` metres of one plane joined to one, as those of a hull whose points were
/// rounded: a box stands on four corners of one face then, not on one of two triangles. Corners that lose all but two faces are
/// left out. Each face's plane keeps all vertices behind it. Where joined faces would not be simple, all stay as they were.
///
/// The tolerance must be small against the polytope's breadth.
Polytope withMergedFaces(const Polytope& polytope, double tolerance);

}  // namespace rubble
