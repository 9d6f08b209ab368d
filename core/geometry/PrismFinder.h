#pragma once

#include "core/base/Result.h"
#include "core/geometry/Polygon.h"
#include "core/geometry/TriangleMesh.h"

#include <string>
#include <vector>

namespace rubble {

/// Along which axis a mesh is to be taken as a prism: the one that makes it thinnest, or the one nearest to an axis of
/// the world.
enum class AxisChoice { Thinnest, X, Y, Z };

/// A mesh taken as a prism: an outline in the xy plane of its frame, from z = -depth/2 to depth/2.
struct FoundPrism {
    Polygon outline;                  // m, canonical; the frame's origin is the middle of its bounding box
    double depth = 0.0;               // m
    Pose pose;                        // world from the prism's frame: there it is the mesh again
    Vec3 axis{0.0, 0.0, 1.0};         // the frame's z in the world
    double deviation = 0.0;           // m, the farthest that a point of the mesh lies from the prism's surface
    std::size_t straightCorners = 0;  // points along the outline that were left out, since they lie on straight lines
    std::vector<Vec3> otherAxes;      // along which the mesh is a prism as well
};

/// Finds the prism that a solid mesh (solidOf()) is, along any axis. Where there are several axes, as in a
/// cuboid, the one along which it is thinnest is taken, of equal ones z before x before y; or the one nearest to the axis
/// chosen. Axes within the tolerance of the world's are made those, and outlines with no edge along the frame's axes are
/// turned so that their longest edge is. Numbers are rounded to decimals far below the tolerance.
/// O(n log n + n · k) for k corners of the outline.
///
/// Errors: Degenerate, saying in one sentence with the measured value why the mesh is no prism along the axis that comes
/// nearest: caps missing, shifted, leaning or curved sides, a step; those of outlineOf().
Result<FoundPrism> findPrism(const TriangleMesh& solid, AxisChoice choice, double tolerance);

/// What to take of a mesh that is no prism.
enum class PrismFallback {
    Silhouette,  // its shadow along the axis
    TopCap,      // the flat face at the axis's end
};

/// The prism that stands in for any mesh along an axis of the world (Thinnest: the one along which the mesh is
/// thinnest), as deep as the mesh. The mesh is welded() but need not be closed. Deviation is left at zero.
///
/// Errors: Degenerate where the mesh has no flat face there, or the outline is in pieces; those of outlineOf().
Result<FoundPrism> standInPrism(const TriangleMesh& mesh, AxisChoice choice, PrismFallback fallback, double tolerance);

/// An axis in a sentence: "z", or "(0.6, 0.8, 0)" where it is none of the world's.
std::string axisText(Vec3 axis);
/// A length in a sentence, in the unit that suits it: "3.2 mm", "1.25 m".
std::string lengthText(double metres);

}  // namespace rubble
