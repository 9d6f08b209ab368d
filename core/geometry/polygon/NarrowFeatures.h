#pragma once

#include "core/geometry/polygon/IndexedCorners.h"

#include <compare>
#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// The smallest visible length, relative to an outline's diameter.
inline constexpr double kVisibleFraction = 1e-9;

/// The minimum distance of a polygon's boundary from itself, so that welding never merges distinct points.
struct Clearance {
    double distance = 0.0;  // m between corners, and from a corner to an edge that is not its own
    double sine = 0.0;      // of the angle between the edges at a corner: at a visible length they are `distance` apart
};
/// The required clearance of a polygon: four times the weld distance (LocalFrame.h), since two boundary points and one
/// between them may each differ by it in x and y, which is 2.9 times the distance.
Clearance requiredClearance(const Polygon& polygon);

/// A place where the boundary violates its clearance.
struct NarrowFeature {
    enum class Kind {
        ShortEdge,       // `corner` and the next one, `other`, are too near
        SharpCorner,     // the angle at `corner` is too small; `other` equals `corner`
        CornerNearEdge,  // `corner` is too near to the edge starting at `other`
    };
    std::uint32_t corner = 0;
    std::uint32_t other = 0;
    Kind kind = Kind::ShortEdge;
    auto operator<=>(const NarrowFeature&) const = default;
};

/// A fast sufficient test for a ring that isSimpleAndConvex(): true only if it has twice its clearance, as nearly all
/// pieces have. The corners nearest to the line of an edge of a convex ring are adjacent to the edge. O(n).
bool hasAmpleClearance(std::span<const Vec2> ring, const Clearance& clearance);

/// All narrow features of a polygon without polygonFaults(), sorted; corners near edges are searched for only if no
/// edge is too short. Distances have an error of at most a hundredth of the clearance. O(n log n) if there are none,
/// otherwise O(n log n + k) for k pairs of edges with nearby bounding boxes.
std::vector<NarrowFeature> narrowFeatures(const IndexedCorners& corners, const Clearance& clearance);

}  // namespace rubble
