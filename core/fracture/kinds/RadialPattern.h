#pragma once

#include "core/fracture/layer/LayerForward.h"
#include "core/fracture/layer/LayerParameter.h"
#include "core/geometry/predicates/Vec.h"

namespace rubble {

/// Seeds on concentric rings, like cracks in glass around a hole: one at the centre, and one on each ring at each
/// spoke. Those outside the outline are omitted. A seed keeps its index when rings or spokes are added.
struct RadialPattern {
    Vec2 centre{0.0, 0.0};    // m
    double radius = 0.5;      // m: of the outermost ring
    std::uint32_t rings = 5;  // ring k of n has the radius radius * (k/n)^exponent
    std::uint32_t spokes = 12;
    double exponent = 1.5;    // 1: equidistant rings; above: closer towards the centre
    double rotation = 0.0;    // rad: of the first spoke, counter-clockwise from the x axis
    double variation = 0.25;  // 0: none; 1: up to halfway to the neighbouring ring and spoke

    // In a closed mesh: the rings are repeated along an axis through the centre.
    double centreHeight = 0.0;  // z of the centre, m
    CoordinateAxis axis = CoordinateAxis::Z;
    std::uint32_t layers = 1;   // at the centre and, by turns, on both sides of it
    double layerSpacing = 0.2;  // m

    bool operator==(const RadialPattern&) const = default;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    Status applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const;
    double estimatedPieces(double) const { return static_cast<double>(rings) * spokes + 1.0; }
    double estimatedPiecesIn(const SolidDomain& domain) const;
    static const LayerKind kKind;
    static RadialPattern defaultsFor(const Box3& bounds);
};

}  // namespace rubble
