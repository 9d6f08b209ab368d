#pragma once

#include "core/base/Index.h"
#include "core/geometry/hull/Polytope.h"
#include "core/geometry/hull/PrincipalInertia.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// A convex hull of a body, for collisions: smaller than the solid, so that hulls of neighbours do not touch.
struct PackHull {
    Polytope polytope;
    double inset = 0.0;  // m, >= 0: by which its faces are inside those of the solid
    /// One loop a face: step k of a loop runs from the face's vertex k to the next. Empty: a pack that was read has
    /// none, or the pack has not been written yet.
    std::vector<std::vector<SignedEdge>> signedEdges;
};

/// A neighbouring fragment of the same parent.
struct PackNeighbour {
    std::uint32_t fragment = 0;  // index in Pack::fragments
    double area = 0.0;           // m², of contact
    /// Of the contact, in the asset's frame; of length 1, towards the neighbour. Only in the entry of the smaller index
    /// of both; none in packs of version 1.
    std::optional<Vec3> centroid, normal;
};

/// The extent of a body without its insets, in its own frame.
struct PackBounds {
    Vec3 min{0.0}, max{0.0};  // m
    double radius = 0.0;      // m: of the ball around the origin
    double thinnest = 0.0;    // m: the smallest width of a hull
    bool operator==(const PackBounds&) const = default;
};

/// The whole of an asset, or a fragment.
struct PackBody {
    std::string id;  // "3" for the whole of asset 3, "3/5.17.1" for a fragment
    std::string name;
    std::uint32_t parent = kNone;  // index of the parent fragment; kNone: the whole
    std::uint32_t level = 0;       // of a fragment: that of its parent and one; 0: the whole and its own fragments
    std::uint32_t firstChild = 0;  // index of its first fragment, which are consecutive; 0 if it does not break
    std::uint32_t childCount = 0;
    Vec3 offset{0.0, 0.0, 0.0};                 // of its frame's origin in the asset's frame, m
    double volume = 0.0;                        // m³
    double mass = 0.0;                          // kg
    Vec3 centreOfMass{0.0, 0.0, 0.0};           // in its own frame, m
    Mat3 inertia{0.0};                          // kg·m², about the centre of mass, in its own axes
    std::optional<PrincipalInertia> principal;  // of it; none in packs of version 1, as are the bounds
    std::optional<PackBounds> bounds;
    std::vector<PackNeighbour> neighbours;  // ascending
    /// N·s, > 0: the impact that breaks it. In packs of version 1 only of fragments for which one is set.
    std::optional<double> threshold;
    double gap = 0.0;             // m between its fragments; 0: none
    double lostMass = 0.0;        // kg that the gap takes from them
    std::vector<PackHull> hulls;  // in its own frame
};

}  // namespace rubble
