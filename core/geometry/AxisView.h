#pragma once

#include "core/geometry/Polygon.h"
#include "core/geometry/TriangleMesh.h"

#include <vector>

namespace rubble {

/// A right-handed frame in the world.
struct ViewFrame {
    Vec3 origin{0.0, 0.0, 0.0};
    Vec3 x{1.0, 0.0, 0.0};
    Vec3 y{0.0, 1.0, 0.0};
    Vec3 z{0.0, 0.0, 1.0};
    Vec3 fromWorld(Vec3 point) const;
};

/// The frame whose z looks along `axis` (of length 1): y as far up as can be; x along the world's where z is upright.
ViewFrame frameAlong(Vec3 axis, Vec3 origin);

/// How a triangle lies to an axis.
enum class FaceLie : std::uint8_t {
    Top,      // in the highest plane across the axis
    Bottom,   // in the lowest
    Side,     // along the axis, or narrower than the tolerance as seen along it
    Between,  // across the axis, but in neither plane
    Leaning,
};

/// A mesh seen along an axis.
struct AxisView {
    ViewFrame frame;
    std::vector<Vec3> points;   // in the frame
    double bottom = 0.0;        // mean height of the points in the lowest plane, m
    double top = 0.0;           // and in the highest
    std::vector<FaceLie> lies;  // of the triangles
    bool has(FaceLie lie) const;
    double depth() const { return top - bottom; }
};

/// Looks at a mesh along the frame's z.
AxisView viewedAlong(const TriangleMesh& mesh, const ViewFrame& frame, double tolerance);

/// How wide a triangle is, seen along the frame's z, m: the height over its longest edge as seen.
double widthSeen(const AxisView& view, const TriangleMesh& mesh, std::size_t triangle);

/// The angle between a triangle and the frame's z, degrees: 0 for a side, 90 for a cap.
double leanDegrees(const AxisView& view, const TriangleMesh& mesh, std::size_t triangle);

/// The rings around the triangles of one lie, in the frame's xy plane, with the area to their left as seen against z (so
/// that the rings of bottom triangles run the other way), points on straight lines included. For solid meshes.
std::vector<Ring> boundaryOf(const AxisView& view, const TriangleMesh& mesh, FaceLie lie);

}  // namespace rubble
