#pragma once

#include "core/geometry/hull/Polytope.h"

#include <optional>
#include <vector>

namespace rubble {

/// A face of a hull in the asset's frame.
struct PlacedFace {
    Plane plane;
    std::vector<Vec3> loop;  // counter-clockwise from outside
};

/// Returns the faces of a hull at an offset.
std::vector<PlacedFace> placedFaces(const Polytope& hull, Vec3 offset);

/// Two faces with opposite normals.
struct FaceOverlap {
    double distance = 0.0;  // m, from the first face to the second along the first's normal; negative: they overlap
    double area = 0.0;      // m², of the part of one that lies opposite the other
};

/// Returns how two faces lie opposite each other; nothing if their normals are not opposite, or they are more than
/// `reach` m apart.
std::optional<FaceOverlap> overlapOf(const PlacedFace& first, const PlacedFace& second, double reach);

/// The diameter, in m, of the intersection of two prisms' cross-sections in the xy plane after their sides have been
/// moved outwards by `margin` m; 0 if it is empty. Sides beyond `bounds` are cut off.
double widenedOverlap(const Polytope& first, Vec3 firstOffset, const Polytope& second, Vec3 secondOffset, double margin,
                      const Box2& bounds);

}  // namespace rubble
