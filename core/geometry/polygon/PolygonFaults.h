#pragma once

#include "core/base/Result.h"
#include "core/geometry/polygon/Polygon.h"

#include <optional>
#include <string>
#include <vector>

namespace rubble {

/// The kinds of invalid polygons.
enum class PolygonFaultKind {
    NotFinite,      // a coordinate is NaN or infinite
    OutOfRange,     // a coordinate too large or too small for exact predicates: isExactlyUsable() in Predicates.h
    TooFewPoints,   // a ring has fewer than three points
    RepeatedPoint,  // two consecutive points are equal, including the last and the first
    ZeroArea,       // all points of a ring are collinear
    Crossing,       // two edges cross
    Touching,       // a point or an edge lies on an edge that is not adjacent, or two points coincide
    HoleOutside,    // a hole lies outside the outline
    HolesOverlap,   // a hole lies inside another
    TooNear,        // the boundary violates its clearance: NarrowFeatures.h
};

/// A point of a ring: ring 0 is the outer ring, ring k is hole k - 1.
struct RingPoint {
    int ring = 0;
    int point = 0;
    bool operator==(const RingPoint&) const = default;
};

/// A fault of a polygon and its location; edges are given by their first point.
struct PolygonFault {
    PolygonFaultKind kind;
    RingPoint first;
    RingPoint second;     // the other edge or ring; equal to first if there is none
    Vec2 where;           // m: for drawing; (0, 0) if a coordinate is not finite
    std::string message;  // "The outline crosses itself between points 4 and 9, at (0.5, 2)."
};

/// The faults of the polygon, at most `most` >= 1, in the order of rings and points; empty for a valid polygon. Decided
/// exactly. O(n log n) for n points, plus O(most · n) with faults. Crossings are searched for only if no ring has an
/// invalid point; the nesting of rings is checked only if none cross or touch. Messages count points and holes from 0,
/// as files do.
std::vector<PolygonFault> polygonFaults(const Polygon& polygon, int most = 64);

/// The first of the narrowFeatures() of a polygon without polygonFaults(), as a fault.
std::optional<PolygonFault> narrowFault(const Polygon& polygon);

/// Checks a polygon and returns it in canonical winding.
///
/// Errors: BadInput (not finite, out of range, too few points, repeated point), Degenerate (zero area, too near),
/// Crossing (crossing, touching, hole outside or overlapping), with the message of the first fault.
Result<Polygon> validated(Polygon polygon);

}  // namespace rubble
