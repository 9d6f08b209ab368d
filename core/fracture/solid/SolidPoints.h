#pragma once

#include "core/fracture/solid/InnerFaces.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// Points closer than this, in steps of the lattice, are one where they are joined by an edge: rounding to the lattice
/// may have torn them apart.
inline constexpr double kSolidWeldDistance = kTieDistance;

/// Whether two points are one: closer than kSolidWeldDistance in each coordinate.
bool coincide(Vec3 a, Vec3 b);

/// The coordinates of the points of a cut solid, in steps of the lattice: of the surface's points and then of the
/// Voronoi corners; Voronoi corners outside are zero. Each is computed once, of exact numbers, with an error of a few
/// ulp of the lattice's extent.
struct SolidPoints {
    UninitializedVector<Vec3> onLattice;  // as cut: the corners of the mesh are on the lattice
    UninitializedVector<Vec3> placed;     // on the mesh as it was given: its corners are where they were
};

/// The points of a solid. `corners`: of the mesh as it was given, in steps.
///
/// Errors: Cancelled.
Result<SolidPoints> solidPoints(const LatticeMesh& mesh, std::span<const Vec3> corners, const SolidDiagram& diagram,
                                const SurfacePieces& pieces, const InnerFaces& faces, const TaskContext& task = {});

/// The point that stands for each point: the lowest of those that are joined by edges shorter than kSolidWeldDistance
/// in each coordinate. Corners of the mesh stand for themselves. Empty if the task is cancelled.
std::vector<std::uint32_t> weldedPoints(std::span<const Vec3> points, const SurfacePieces& pieces,
                                        const InnerFaces& faces, const TaskContext& task = {});

}  // namespace rubble
