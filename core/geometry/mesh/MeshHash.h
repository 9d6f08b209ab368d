#pragma once

#include "core/base/Hash.h"
#include "core/geometry/mesh/TriangleMesh.h"

namespace rubble {

/// The hash of the points and triangles of a mesh: that of a ClosedMesh of them.
ContentHash hashOf(const TriangleMesh& mesh);

}  // namespace rubble
