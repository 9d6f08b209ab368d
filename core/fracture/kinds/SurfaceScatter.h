#pragma once

#include "core/fracture/layer/LayerForward.h"
#include "core/fracture/sampling/SeedCount.h"

#include <optional>
#include <string>

namespace rubble {

/// `count` seeds near the surface of a closed mesh, or the outline in the plane, between two depths below it: their
/// density decreases with the depth as (1 - t)^falloff, where t is 0 at the least depth and 1 at the greatest.
/// Increasing the count keeps existing seeds. Reports NoRoom if the domain is so thin that not all can be placed.
struct SurfaceScatter {
    SeedCount count = 60;
    double minDepth = 0.0;  // m
    double maxDepth = 0.1;  // m, not below minDepth
    double falloff = 1.0;   // 0: the same density at all depths

    bool operator==(const SurfaceScatter&) const = default;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    Status applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const;
    std::optional<std::string> fault() const;
    double estimatedPieces(double area) const { return count.in(area); }
    double estimatedPiecesIn(const SolidDomain& domain) const;
    static const LayerKind kKind;
    static SurfaceScatter defaultsFor(const Box3& bounds);
};

}  // namespace rubble
