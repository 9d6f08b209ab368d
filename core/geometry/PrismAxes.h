#pragma once

#include "core/geometry/TriangleMesh.h"

#include <vector>

namespace rubble {

/// The axis made one of the world's where a mesh of that size (m) turns by less than the tolerance; pointing
/// along the world's z, x or y, whichever it is nearest to, not against.
Vec3 tidiedAxis(Vec3 axis, double size, double tolerance);

/// The only axes along which a solid mesh can be a prism, at most three: a prism's largest face and the face most across
/// that are a cap and a side, or two sides, whose common direction is the axis. O(n).
std::vector<Vec3> possibleAxes(const TriangleMesh& mesh, double tolerance);

/// Axes along which to say why a mesh is none: those, the world's, and those across its larger flat parts.
std::vector<Vec3> arguableAxes(const TriangleMesh& mesh, double tolerance);

}  // namespace rubble
