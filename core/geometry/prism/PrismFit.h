#pragma once

#include "core/base/Result.h"
#include "core/geometry/mesh/TriangleMesh.h"
#include "core/geometry/polygon/Polygon.h"

#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// The axis along which to fit a prism: the one with the smallest depth, or the one nearest to a world axis.
enum class PrismAxis { Thinnest, X, Y, Z };

/// A prism fitted to a mesh: an outline in the xy plane of its frame, from z = -depth/2 to depth/2.
struct PrismFit {
    Polygon outline;                   // m, canonical winding; the frame's origin is the centre of its bounding box
    double depth = 0.0;                // m
    Pose pose;                         // world from the prism's frame
    Vec3 axis{0.0, 0.0, 1.0};          // the frame's z in world space
    double deviation = 0.0;            // m: the largest distance of a point of the mesh from the prism's surface
    std::size_t collinearCorners = 0;  // collinear points removed from the outline
    std::vector<Vec3> otherAxes;       // other axes along which the mesh is a prism
};

/// Fits a prism to a solid mesh (orientedSolid()), along any axis. Of several axes, as in a cuboid, it uses the one
/// with the smallest depth, of equal ones z before x before y, or the one nearest to the requested world axis. Axes are
/// snapped to world axes within the tolerance, and an outline without an edge along the frame's axes is rotated so that
/// its longest edge is. Numbers are rounded to decimals far below the tolerance. O(n log n + n · k) for k corners of
/// the outline.
///
/// Errors: Degenerate, with the reason and the measured value for the most promising axis, if the mesh is not a prism:
/// missing or shifted caps, oblique or curved sides, a step; those of outlineOf().
Result<PrismFit> fitPrism(const TriangleMesh& solid, PrismAxis axis, double tolerance);

/// Fits a prism to a solid mesh whose points were rounded, each displaced by at most `rounding`, m: between its caps,
/// with the volume of the mesh, along the axis of least squares. Other rules are those of fitPrism(). Nothing if the
/// rounding does not explain how the mesh differs from a prism: no point may be farther from it than twice that.
std::optional<PrismFit> fitRoundedPrism(const TriangleMesh& solid, PrismAxis axis, double tolerance, double rounding);

/// The smallest extent of a prism, m: its depth, or a side of its outline's bounding box.
double smallestExtent(const PrismFit& prism);

/// The volume of a prism, m³.
double volumeOf(const PrismFit& prism);

/// The outline to use for a mesh that is not a prism.
enum class PrismFallback {
    Silhouette,  // the projection along the axis
    TopCap,      // the flat face at the end of the axis
};

/// A substitute prism for any mesh along a world axis, with the mesh's depth (Thinnest: the axis with the smallest
/// depth). The mesh must be welded() but need not be closed. The deviation is not computed.
///
/// Errors: Degenerate if the mesh has no flat face there, or the outline has several parts; those of outlineOf().
Result<PrismFit> fallbackPrism(const TriangleMesh& mesh, PrismAxis axis, PrismFallback fallback, double tolerance);

/// An axis for a message: "z", or "(0.6, 0.8, 0)" if it is not a world axis.
std::string axisText(Vec3 axis);
/// A length for a message, in a suitable unit: "3.2 mm", "1.25 m".
std::string lengthText(double metres);

}  // namespace rubble
