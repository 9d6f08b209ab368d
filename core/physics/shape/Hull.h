#pragma once

#include "core/base/Result.h"
#include "core/geometry/hull/Polytope.h"
#include "core/physics/math/Vec3f.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// The maximum number of corners of a hull. The hulls of fragments have about 12 to 20; larger ones slow collision down
/// without improving it.
inline constexpr int kMaxHullCorners = 256;

/// The least angle between adjacent faces of hulls that stand for a body of corners, not for a round one, rad.
inline constexpr float kSharpTurn = 0.2f;

/// The points x with dot(normal, x) <= offset.
struct HullPlane {
    Vec3f normal{0.0f, 1.0f, 0.0f};
    float offset = 0.0f;  // m
};

/// An edge and its two faces.
struct HullEdge {
    std::uint16_t from = 0;
    std::uint16_t to = 0;
    std::uint16_t firstFace = 0;
    std::uint16_t secondFace = 0;
};

/// Vectors as a structure of arrays, padded to a multiple of four.
struct VectorRows {
    std::vector<float> x, y, z;
};

/// A convex hull for collision detection, relative to a centre of mass.
struct Hull {
    int cornerCount = 0;
    VectorRows corners;  // padded with copies of the first
    std::vector<HullPlane> planes;
    std::vector<HullEdge> edges;
    std::vector<std::uint16_t> loops;        // corner indices of all faces, each counter-clockwise from outside
    std::vector<std::uint16_t> firstInLoop;  // per face, and the end
    std::vector<HullPlane> sides;  // per entry of `loops`: contains the edge starting there, perpendicular to the face
    // Per edge, padded with zeros: its vector, its first corner, the normals of its two faces.
    VectorRows edgeVectors, edgeCorners, edgeFirstNormals, edgeSecondNormals;
    Vec3f mean{0.0f, 0.0f, 0.0f};     // of the corners: inside, which the centre of mass need not be
    float meanDepth = 0.0f;           // m: how far inside the mean is
    Vec3f middle{0.0f, 0.0f, 0.0f};   // of the bounding box
    Vec3f extents{0.0f, 0.0f, 0.0f};  // half the sides of the bounding box
    float minWidth = 0.0f;            // m: the least extent along a face normal
    float minTurn = 1.0f;             // the sine of the least angle between two adjacent normals, 1 at 90 degrees
    float coarseTurn = 1.0f;          // the same, where faces within 0.2 mm of a common plane count as one
    float boundingRadius = 0.0f;      // m: distance from the centre of mass to the farthest corner
    float innerRadius = 0.0f;  // m: distance from the centre of mass to the nearest plane; -boundingRadius if outside

    Vec3f corner(int index) const { return Vec3f(corners.x[index], corners.y[index], corners.z[index]); }
    std::span<const std::uint16_t> face(int index) const {
        return std::span(loops).subspan(firstInLoop[index], firstInLoop[index + 1] - firstInLoop[index]);
    }
    std::span<const HullPlane> sidesOf(int face) const {
        return std::span(sides).subspan(firstInLoop[face], firstInLoop[face + 1] - firstInLoop[face]);
    }
    /// The support point: the corner farthest along a direction; ties go to the first.
    int farthest(Vec3f direction) const;
    /// The face whose normal is closest to a direction; ties go to the first.
    int faceAlong(Vec3f direction) const;
};

/// The hull of a polytope, translated by -centre and simplified: corners within 1 mm or 2 % of the minimum width,
/// whichever is less, are welded, since Voronoi cells have tiny sides whose normals are inaccurate; faces within 1 µm
/// or 5e-6 of that width of a common plane are merged.
///
/// Errors: BadInput for more than kMaxHullCorners corners; Degenerate for fewer than four, or no volume.
Result<Hull> makeHull(const Polytope& polytope, Vec3 centre);

}  // namespace rubble
