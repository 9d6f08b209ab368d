#pragma once

#include "core/geometry/hull/Polytope.h"
#include "core/physics/shape/Hull.h"

#include <span>
#include <vector>

namespace rubble {

/// A convex polygon in space, counter-clockwise as seen from the viewpoint, which is the origin.
using FacePolygon = std::vector<Vec3>;

/// A convex hull as seen from the viewpoint, which is the origin: the faces turned to it, and what it hides. A point is
/// hidden if it is behind all `planes`. Without planes, the hull contains the viewpoint; it has no faces then either,
/// and hides nothing.
struct ShadowVolume {
    std::vector<FacePolygon> faces;
    std::vector<Plane> planes;  // of the faces, then through the viewpoint and the edges of the silhouette
};

/// The shadow volume of a hull with its corners at `rotation * corner + centre`. O(n) for n corners, edges and faces.
ShadowVolume shadowVolumeOf(const Hull& hull, const Mat3& rotation, Vec3 centre);

/// The parts of a convex polygon on both sides of a plane; empty where it reaches no farther than 10 µm there. One in
/// the plane is behind it.
struct SplitPolygon {
    FacePolygon front, behind;
};
SplitPolygon split(const FacePolygon& polygon, const Plane& plane);

/// Whether a point is hidden; one on the surface of the volume is not.
bool isHidden(const ShadowVolume& volume, Vec3 point);

/// Whether a volume hides all of a convex polygon, within 10 µm.
bool isHidden(const ShadowVolume& volume, const FacePolygon& polygon);

/// Appends the convex parts of a polygon that a volume does not hide. Faces that touch the hull from behind are hidden;
/// one that is level with a face of it is not. Returns false, and appends nothing, if it hides no part.
bool subtractShadow(const FacePolygon& polygon, const ShadowVolume& volume, std::vector<FacePolygon>& visible);

}  // namespace rubble
