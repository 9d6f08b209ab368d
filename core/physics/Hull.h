#pragma once

#include "core/base/Result.h"
#include "core/geometry/Polytope.h"
#include "core/physics/Vec3f.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// Hulls of fragments have some 12 to 20 corners; more than this many serves no simulation.
inline constexpr int kMostHullCorners = 256;

/// The points x with dot(normal, x) <= offset.
struct HullPlane {
    Vec3f normal{0.0f, 1.0f, 0.0f};
    float offset = 0.0f;  // m
};

/// An edge with its two faces.
struct HullEdge {
    std::uint16_t from = 0;
    std::uint16_t to = 0;
    std::uint16_t firstFace = 0;
    std::uint16_t secondFace = 0;
};

/// Vectors side by side by coordinate, padded to a multiple of four.
struct VectorRows {
    std::vector<float> x, y, z;
};

/// A convex body for collision: corners, faces and edges around a centre of mass.
struct Hull {
    int cornerCount = 0;
    VectorRows corners;  // padded with the first
    std::vector<HullPlane> planes;
    std::vector<HullEdge> edges;
    std::vector<std::uint16_t> loops;        // corners of all faces, each counter-clockwise from outside
    std::vector<std::uint16_t> firstInLoop;  // one a face and one more
    std::vector<HullPlane> sides;  // one a corner of `loops`: through the edge that leaves it, square to the face
    // By edge, padded with zeros: from the first corner to the second, the first corner, the normals of both faces.
    VectorRows edgeVectors, edgeCorners, edgeFirstNormals, edgeSecondNormals;
    Vec3f middle{0.0f, 0.0f, 0.0f};   // of its box
    Vec3f extents{0.0f, 0.0f, 0.0f};  // half of the box's sides
    float breadth = 0.0f;             // m: the least width across a pair of faces
    float reach = 0.0f;               // m: from the centre of mass to the farthest corner
    float inner = 0.0f;               // m: from the centre of mass to the nearest plane; -reach where it lies outside

    Vec3f corner(int index) const { return Vec3f(corners.x[index], corners.y[index], corners.z[index]); }
    std::span<const std::uint16_t> face(int index) const {
        return std::span(loops).subspan(firstInLoop[index], firstInLoop[index + 1] - firstInLoop[index]);
    }
    std::span<const HullPlane> sidesOf(int face) const {
        return std::span(sides).subspan(firstInLoop[face], firstInLoop[face + 1] - firstInLoop[face]);
    }
    /// The corner farthest along a direction; of equals the first.
    int farthest(Vec3f direction) const;
    /// The face whose normal lies farthest along a direction; of equals the first.
    int facing(Vec3f direction) const;
};

/// The hull of a polytope, moved by -centre. Corners nearer to each other than 1 mm, or a fiftieth of its breadth where that is
/// less, become one: Voronoi cells have tiny sides, whose normals say little about the body. So do faces within 1 mm of one
/// plane, or half a percent of the breadth.
///
/// Errors: BadInput where it has more than kMostHullCorners corners; Degenerate where it has fewer than four or no volume.
Result<Hull> makeHull(const Polytope& polytope, Vec3 centre);

}  // namespace rubble
