#pragma once

#include "core/geometry/mesh/TriangleMesh.h"

#include <vector>

namespace rubble {

/// The axis, snapped to a world axis if that displaces no point of a mesh of that size (m) by more than the tolerance.
/// Its sign is that of the nearest positive world axis.
Vec3 snappedAxis(Vec3 axis, double size, double tolerance);

/// The only axes along which a solid mesh can be a prism, at most three: the largest face of a prism and the face most
/// perpendicular to it are a cap and a side, or two sides, whose common direction is the axis. O(n).
std::vector<Vec3> candidateAxes(const TriangleMesh& mesh, double tolerance);

/// The axes for explaining why a mesh is not a prism: the candidates, the world axes, and the normals of its largest
/// planar regions.
std::vector<Vec3> diagnosticAxes(const TriangleMesh& mesh, double tolerance);

}  // namespace rubble
