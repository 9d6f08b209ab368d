#pragma once

#include "core/geometry/polygon/Polygon.h"

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

/// A closed convex polytope.
struct Polytope {
    std::vector<Vec3> vertices;
    std::vector<std::array<std::uint32_t, 2>> edges;  // each once
    std::vector<std::vector<std::uint32_t>> faces;    // vertex loops, counter-clockwise from outside
    std::vector<Plane> planes;                        // one per face
    bool operator==(const Polytope&) const = default;
};

/// An edge of a face loop: its index, and +1 if the loop runs from its first vertex to its second, otherwise -1.
struct SignedEdge {
    std::uint32_t edge = 0;
    int sign = 1;
};

/// The prism over a convex counter-clockwise ring of n corners between two heights. Vertices: n at zMax, then n at
/// zMin. Edges: n of the front, n of the back, n from front to back. Faces: front, back, then n sides, side i over the
/// ring's edge from corner i. Collinear corners are removed (no two side faces are coplanar), as are corners that are
/// reflex by rounding. Empty if fewer than three remain.
Polytope extruded(std::span<const Vec2> convexRing, double zMin, double zMax);

/// The faces as closed loops of signed edges, each starting with two edges that are not collinear.
std::vector<std::vector<SignedEdge>> signedEdgeLoops(const Polytope& polytope);

/// The polytope translated by an offset.
Polytope translated(Polytope polytope, Vec3 offset);
/// The polytope in another frame, in which its own is at `pose`.
Polytope placed(Polytope polytope, const Pose& pose);

/// Why a polytope is invalid: an index out of range, an edge without two faces, a face that is not planar (within 1e-9
/// of the size), faces inward or has a vertex in front of it, or an Euler number other than two. Nothing for a valid
/// one.
std::optional<std::string> verifyPolytope(const Polytope& polytope);

}  // namespace rubble
