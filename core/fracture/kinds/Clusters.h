#pragma once

#include "core/fracture/layer/LayerForward.h"

namespace rubble {

/// Clusters of seeds: each has a random centre in the outline and seeds around it, denser towards the centre. A seed
/// keeps its index and position when clusters or seeds are added. Reports NoRoom if the outline is so thin that a seed,
/// not deleted by hand, cannot be placed.
struct Clusters {
    std::uint32_t clusters = 6;
    std::uint32_t seedsPerCluster = 8;
    double radius = 0.15;  // m

    bool operator==(const Clusters&) const = default;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    Status applyInSolid(const SolidLayerContext& context, SeedSet& seeds) const;
    double estimatedPieces(double) const { return static_cast<double>(clusters) * seedsPerCluster; }
    double estimatedPiecesIn(const SolidDomain& domain) const;
    static const LayerKind kKind;
    static Clusters defaultsFor(const Box3& bounds);
};

}  // namespace rubble
