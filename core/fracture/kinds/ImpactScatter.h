#pragma once

#include "core/fracture/layer/LayerForward.h"
#include "core/fracture/layer/SeedDensity.h"
#include "core/fracture/sampling/SeedCount.h"
#include "core/geometry/predicates/Vec.h"

namespace rubble {

/// `count` seeds around a point of impact: at a distance d their density is proportional to (1 +
/// (d/radius)²)^(-falloff/2), almost constant within the radius and decreasing as d^-falloff beyond it. Increasing the
/// count keeps existing seeds.
struct ImpactScatter {
    Vec2 centre{0.0, 0.0};  // m; may lie outside the outline
    SeedCount count = 60;
    double radius = 0.1;        // m
    double falloff = 2.5;       // 0: the same density everywhere
    double centreHeight = 0.0;  // z of the centre, m, in a closed mesh

    bool operator==(const ImpactScatter&) const = default;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    Status applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const;
    SeedDensity density(const Polygon& outline) const;
    double estimatedPieces(double area) const { return count.in(area); }
    double estimatedPiecesIn(const SolidDomain& domain) const;
    static const LayerKind kKind;
    static ImpactScatter defaultsFor(const Box3& bounds);
};

}  // namespace rubble
