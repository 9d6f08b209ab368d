#pragma once

#include "viewport/scene/SceneGeometry.h"

namespace rubble {

/// Appends a piece with the triangles of a mesh of which nothing is promised: it may be open or look inward, so that both
/// sides of each triangle are drawn, the back as inside. An edge shows where the surface ends, or bends by more than a
/// degree. O(n log n).
void addSurface(SceneGeometry& geometry, const TriangleMesh& mesh);

}  // namespace rubble
