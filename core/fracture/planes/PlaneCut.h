#pragma once

#include "core/fracture/planes/SectionPlane.h"
#include "core/fracture/solid/SolidFaces.h"
#include "core/fracture/solid/SolidPartition.h"
#include "core/fracture/solid/SolidShells.h"
#include "core/geometry/mesh/SolidLattice.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// A triangle of a closed surface, counter-clockwise from outside.
struct SolidTriangle {
    std::array<std::uint32_t, 3> corners{};  // points
    std::uint32_t tag = 0;                   // what it is a part of; its parts keep it
};

/// The surface of one fragment, with points of its own.
struct FragmentSurface {
    std::vector<Vec3> points;              // m, relative to the partition's origin
    std::vector<std::uint32_t> names;      // of the points in the partition, ascending
    std::vector<SolidTriangle> triangles;  // tag: the place of the face in facesOf(fragment)
};
FragmentSurface surfaceOf(const SolidPartition& partition, std::uint32_t fragment);

/// Where a plane cuts an edge.
struct PlaneCrossing {
    std::uint32_t low = 0, high = 0;  // points of its ends
    std::uint32_t point = 0;
};

/// A closed surface cut by a plane.
struct PlaneCut {
    /// Faces of the cells 0, below the plane, and 1, above it. Those of the surface are a triangle each, with its tag
    /// as `source`; those in the plane, made by the cut, have the cell 1 behind them.
    SolidFaces faces;
    std::vector<PlaneCrossing> edges;  // ascending by their ends
};

/// Cuts a closed surface by a plane, whose normal points up, and appends the points where edges are cut. Points within
/// `tolerance` metres of the plane are in it and stay; triangles in it are on the side where the solid is. Both sides
/// are closed, each edge there as often in one direction as in the other. A surface that is not cut has one side and no
/// faces in the plane. O(n log n).
PlaneCut cutByPlane(std::span<const SolidTriangle> surface, std::vector<Vec3>& points, const SectionPlane& plane,
                    double tolerance);

/// Shells below this volume may be there because of rounding: that of a needle as thick as some tie distances and as
/// long as the solid, in units of shellsOf().
inline constexpr double kMinShellVolume = 16.0 * kTieDistance * kTieDistance * kLatticeSteps;

/// The shells of faces, with kTieDistance as the length of `tolerance` metres.
///
/// Errors: Cancelled.
Result<SolidShells> shellsOf(const SolidFaces& faces, std::span<const Vec3> points, double tolerance,
                             const TaskContext& task = {});

/// How near a point of a partition may be to a plane to count as in it, m.
double planeTolerance(const SolidPartition& partition);

}  // namespace rubble
