#pragma once

#include "core/geometry/hull/Polytope.h"

#include <cstddef>

namespace rubble {

/// How far a hull is simplified.
struct HullDetail {
    double tolerance = 0.0;      // m: the most that a corner may be outside
    std::size_t maxCorners = 4;  // >= 4: as many corners have no tolerance
};

// What hulls of meshes lose for collisions. A millimetre is the hull tolerance of Jolt, and little beside what is seen;
// hulls that are small or thin keep their shape.
inline constexpr double kMaxHullError = 1e-3;  // m
inline constexpr double kMaxHullErrorOfDiagonal = 2.5e-3;
inline constexpr double kMaxHullErrorOfWidth = 0.01;  // of the least width
// PhysX collides hulls of up to 64 corners on the GPU, and 255 elsewhere (PxConvexMeshDesc); Jolt takes 256.
inline constexpr std::size_t kMaxCollisionCorners = 64;
inline constexpr double kMaxErrorAtMostCorners = 0.03;  // of the diagonal, for a sphere

/// How far a hull of a mesh is simplified for collisions.
HullDetail collisionDetail(const Polytope& hull);

/// The most that corners of a mesh are outside a hull of so many corners that was simplified for collisions, m.
/// `diagonal`: of the mesh.
double maxCollisionError(std::size_t corners, double diagonal);

/// The convex hull of some of the corners of a hull, so that it lies in it: corners are added one at a time, of those
/// that are farther outside than the tolerance the one that adds the most volume, until there is none or there are as
/// many as allowed. The hull itself if that needs all of its corners. O(n c) for n corners of which c remain.
Polytope simplifiedHull(const Polytope& hull, const HullDetail& detail);

}  // namespace rubble
