#pragma once

#include "viewport/scene/SceneGeometry.h"

namespace rubble {

/// Appends a solid with the triangles of an arbitrary mesh: it may be open or inside out, so both sides of each
/// triangle are drawn, the back as inside. Visible edges are boundaries and creases of more than one degree. O(n log
/// n).
void addSurface(SceneGeometry& geometry, const TriangleMesh& mesh);

}  // namespace rubble
