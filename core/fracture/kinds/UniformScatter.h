#pragma once

#include "core/fracture/layer/LayerForward.h"
#include "core/fracture/sampling/ScatterDomain.h"
#include "core/fracture/sampling/SeedCount.h"

namespace rubble {

/// `count` uniformly random seeds. Increasing the count keeps existing seeds.
struct UniformScatter {
    SeedCount count = 20;
    ScatterDomain domain = ScatterDomain::Outline;

    bool operator==(const UniformScatter&) const = default;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    Status applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const;
    double estimatedPieces(double area) const { return count.in(area); }
    double estimatedPiecesIn(const SolidDomain& domain) const;
    static const LayerKind kKind;
};

}  // namespace rubble
