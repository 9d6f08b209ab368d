#pragma once

#include "core/fracture/layer/LayerForward.h"
#include "core/geometry/predicates/Vec.h"

namespace rubble {

/// Cracks as in a pane around the point where it was hit. Long cracks run outwards from a closed ring, the hole, to the
/// outline; arcs of further rings join neighbouring ones, fewer with the distance; short cracks start on arcs and run
/// outwards, too, to the next arc or the outline.
struct RadialCracks {
    Vec2 centre{0.0, 0.0};      // m
    double radius = 0.5;        // m: of the outermost ring
    std::uint32_t rings = 5;    // ring k of n has the radius radius * (k/n)^exponent; the first is the hole
    std::uint32_t spokes = 12;  // long cracks
    double exponent = 1.5;      // 1: equidistant rings; above: closer towards the centre
    double rotation = 0.0;      // rad: of the first long crack, counter-clockwise from the x axis
    double variation = 0.5;     // 0: regular; 1: up to halfway to the neighbouring ring and crack

    bool operator==(const RadialCracks&) const = default;
    Status cut(const LayerContext& context, CutSet& cuts) const;
    double estimatedPieces(double) const { return (rings + 1.0) * spokes + 1.0; }
    static const LayerKind kKind;
    static RadialCracks defaultsFor(const Box3& bounds);
};

}  // namespace rubble
