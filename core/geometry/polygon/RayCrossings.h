#pragma once

#include "core/geometry/predicates/Vec.h"

namespace rubble {

/// Whether a point lies on one of some edges, and whether a ray from it to the right crosses them an odd number of
/// times; decided exactly. Edges to the left of the point, above and below it change neither.
struct RayCrossings {
    bool isOnEdge = false;
    bool isOdd = false;

    void add(Vec2 from, Vec2 to, Vec2 point);
};

}  // namespace rubble
