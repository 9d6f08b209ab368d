#pragma once

#include "core/geometry/NumberedCorners.h"

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// Lengths below this part of an outline's diameter are too short to be seen.
inline constexpr double kVisiblePart = 1e-9;

/// How far a polygon's boundary keeps from itself, so that its points stay apart when others that are one are joined.
struct Clearance {
    double distance = 0.0;  // m between corners, and from a corner to an edge that is not its own
    double sine = 0.0;      // of the angle between the edges at a corner: a visible length away they are that far apart
};
/// Four times the distance within which points are one (PointFrame.h): two of the boundary and one between them may lie
/// that far apart in x and in y each, which is 2.9 times the distance.
Clearance clearanceOf(const Polygon& polygon);

/// A place where the boundary does not keep its clearance.
struct NarrowPlace {
    enum class Kind {
        ShortEdge,       // `corner` and `other`, the next one of its ring, are too near
        SharpCorner,     // the edges at `corner` run too near to each other; `other` is the corner itself
        CornerNearEdge,  // `corner` is too near to the edge that starts at `other`
    };
    std::uint32_t corner = 0;
    std::uint32_t other = 0;
    Kind kind = Kind::ShortEdge;
    auto operator<=>(const NarrowPlace&) const = default;
};

/// True only for a ring isSimpleAndConvex() that keeps its clearance with room to spare: told at once of nearly all pieces. There the
/// corners nearest to an edge's line are those beside the edge. O(n).
bool isClearlyWide(std::span<const Vec2> ring, const Clearance& clearance);

/// All narrow places of a polygon without polygonFaults(), ascending; where edges are short, no corners near edges. Distances
/// are computed to a hundredth of the clearance. O(n log n) for n edges of which few overlap in x; at worst O(n^2).
std::vector<NarrowPlace> narrowPlaces(const NumberedCorners& corners, const Clearance& clearance);

}  // namespace rubble
