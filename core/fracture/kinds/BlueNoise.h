#pragma once

#include "core/fracture/layer/LayerForward.h"
#include "core/fracture/sampling/ScatterDomain.h"
#include "core/fracture/sampling/SeedCount.h"

namespace rubble {

/// Random seeds with a minimum distance (Poisson-disk sampling): `count` of them, or as many as fit. Increasing the
/// count keeps existing seeds.
struct BlueNoise {
    double minimumDistance = 0.1;  // m
    SeedCount count = 0;           // the number 0: as many as fit
    ScatterDomain domain = ScatterDomain::Outline;

    bool operator==(const BlueNoise&) const = default;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    Status applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const;
    double estimatedPieces(double area) const;
    double estimatedPiecesIn(const SolidDomain& domain) const;
    static const LayerKind kKind;
    static BlueNoise defaultsFor(const Box3& bounds);
};

}  // namespace rubble
