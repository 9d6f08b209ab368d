#pragma once

#include "core/geometry/mesh/TriangleMesh.h"
#include "core/geometry/polygon/Polygon.h"

#include <vector>

namespace rubble {

/// A right-handed frame in world space.
struct ViewFrame {
    Vec3 origin{0.0, 0.0, 0.0};
    Vec3 x{1.0, 0.0, 0.0};
    Vec3 y{0.0, 1.0, 0.0};
    Vec3 z{0.0, 0.0, 1.0};
    Vec3 fromWorld(Vec3 point) const;
};

/// The frame whose z is `axis`, of length 1, and whose y is as close to up as possible; if the axis is upright, its x
/// is near the world's.
ViewFrame frameAlong(Vec3 axis, Vec3 origin);

/// The orientation of a triangle relative to an axis.
enum class FaceOrientation : std::uint8_t {
    Top,      // in the highest plane perpendicular to the axis
    Bottom,   // in the lowest plane
    Side,     // parallel to the axis: narrower than the tolerance in projection
    Between,  // perpendicular to the axis, in neither plane
    Oblique,
};

/// A mesh in the frame of an axis.
struct AxisView {
    ViewFrame frame;
    std::vector<Vec3> points;                   // in the frame
    double bottom = 0.0;                        // m: mean height of the points in the lowest plane
    double top = 0.0;                           // m: mean height of the points in the highest plane
    std::vector<FaceOrientation> orientations;  // of the triangles
    bool has(FaceOrientation orientation) const;
    double depth() const { return top - bottom; }
};

/// Transforms a mesh and classifies its triangles along the frame's z.
AxisView viewAlong(const TriangleMesh& mesh, const ViewFrame& frame, double tolerance);

/// The width of a triangle projected along the frame's z, m: its height over the longest edge.
double projectedWidth(const AxisView& view, const TriangleMesh& mesh, std::size_t triangle);

/// The angle between a triangle and the frame's z, degrees: 0 for a side, 90 for a cap.
double tiltDegrees(const AxisView& view, const TriangleMesh& mesh, std::size_t triangle);

/// The boundary rings of the triangles of one orientation, projected to the frame's xy plane, including collinear
/// points. The area is to the left of rings seen from outside, so that rings of bottom triangles are reversed. For
/// solid meshes.
std::vector<Ring> boundaryOf(const AxisView& view, const TriangleMesh& mesh, FaceOrientation orientation);

}  // namespace rubble
