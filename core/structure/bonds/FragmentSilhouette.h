#pragma once

#include "core/fracture/fragments/Fragment.h"
#include "core/geometry/polygon/Polygon.h"

namespace rubble {

/// A fragment as strokes of brushes meet it, seen along z, m, relative to its centre of mass: its outline; of a mesh,
/// the convex hull of its silhouette.
Polygon silhouetteOf(const Fragment& fragment);

/// Its extent along z, m.
double depthOf(const Fragment& fragment);

}  // namespace rubble
