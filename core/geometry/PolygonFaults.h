#pragma once

#include "core/base/Result.h"
#include "core/geometry/Polygon.h"

#include <optional>
#include <string>
#include <vector>

namespace rubble {

enum class PolygonFaultKind {
    NotFinite,      // a coordinate is NaN or infinite
    OutOfRange,     // a coordinate too large or too small for exact signs: isExactlyUsable() in Predicates.h
    TooFewPoints,   // a ring has fewer than three points
    RepeatedPoint,  // two neighbouring points are equal, the last and the first included
    ZeroArea,       // all points of a ring lie on one line
    Crossing,       // two edges cross
    Touching,       // a point or an edge lies on an edge it is not joined to, or two points coincide
    HoleOutside,    // a hole lies outside the outline
    HolesOverlap,   // a hole lies inside another
    TooNear,        // places of the boundary are nearer than its clearance: NarrowPlaces.h
};

/// Which point of which ring: ring 0 is the outer one, ring k hole k - 1.
struct RingPoint {
    int ring = 0;
    int point = 0;
    bool operator==(const RingPoint&) const = default;
};

/// One thing that is wrong with a polygon and where; edges are named by their first point.
struct PolygonFault {
    PolygonFaultKind kind;
    RingPoint first;
    RingPoint second;     // the other edge or ring; equal to first where there is none
    Vec2 where;           // where to draw it; (0, 0) where a coordinate is not finite
    std::string message;  // "The outline crosses itself between points 4 and 9, at (0.5, 2)."
};

/// Every fault of the polygon (at most `most` >= 1), in the order of rings and points; empty where there is
/// none. Decided exactly. O(n log n) for n points, O(most · n) where there are faults. Crossings are looked for
/// only where no ring has a fault of its own points, the nesting of rings only where none cross or touch.
/// Sentences count points and holes from 0, as files do.
std::vector<PolygonFault> polygonFaults(const Polygon& polygon, int most = 64);

/// What makes a polygon without polygonFaults() too narrow to be cut: the first of its narrowPlaces().
std::optional<PolygonFault> narrowFault(const Polygon& polygon);

/// The polygon in canonical winding.
///
/// Errors: BadInput (not finite, out of range, too few points, repeated point), Degenerate (zero area, too near),
/// Crossing (crossing, touching, hole outside or overlapping), each with the sentence of the first fault.
Result<Polygon> validated(Polygon polygon);

}  // namespace rubble
