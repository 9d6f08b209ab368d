#pragma once

#include "core/geometry/Polygon.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// The points x with normal · x <= offset; the normal has length 1 and points outwards.
struct Plane {
    Vec3 normal{0.0, 0.0, 1.0};
    double offset = 0.0;  // m
    bool operator==(const Plane&) const = default;
};

/// A closed convex body as vertices, edges, faces and planes, all linked by index.
struct Polytope {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 2>> edges;  // each once, first to second
    std::vector<std::vector<std::uint32_t>> faces;    // vertex loops, counter-clockwise from outside
    std::vector<Plane> planes;                        // one a face
    bool operator==(const Polytope&) const = default;
};

/// An edge as a face's loop runs along it: the index, and +1 where the loop goes from its first
/// vertex to its second, -1 otherwise.
struct SignedEdge {
    std::uint32_t edge = 0;
    int sign = 1;
};

/// The prism over a convex counter-clockwise ring of n corners between two heights. Vertices: n at zMax, then
/// n at zMin. Edges: n along the front, n along the back, n from front to back. Faces: front, back, then n sides,
/// side i over the ring's edge from corner i. Corners on a straight side are left out (no two coplanar side faces), as
/// are those that rounding made turn right. Empty where fewer than three corners are left.
Polytope extruded(std::span<const Vec2> convexRing, double zMin, double zMax);

/// The faces as signed edges: closed loops that begin with two edges that are not collinear.
std::vector<std::vector<SignedEdge>> signedEdgeLoops(const Polytope& polytope);

/// The polytope moved by an offset.
Polytope translated(Polytope polytope, Vec3 offset);

/// Says what is wrong: not closed, a face not planar (relative 1e-9 of its size), inward, an index out of
/// range, an edge without two faces, not convex, an Euler number other than two. Nothing where all is well.
std::optional<std::string> verifyPolytope(const Polytope& polytope);

}  // namespace rubble
