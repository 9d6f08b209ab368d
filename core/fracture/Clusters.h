#pragma once

#include "core/fracture/PatternKindForward.h"

namespace rubble {

/// Seeds in heaps: each cluster has its middle anywhere in the outline and its seeds about it, denser towards the middle. A seed
/// keeps its index and its place when clusters or seeds are added. Reported is NoRoom where the outline is so thin that seeds find none
/// and are not deleted by hand either.
struct Clusters {
    std::uint32_t clusters = 6;
    std::uint32_t seedsPerCluster = 8;
    double radius = 0.15;  // m

    bool operator==(const Clusters&) const = default;
    Status apply(const LayerContext& context, SeedSet& seeds) const;
    static const PatternKind kKind;
};

}  // namespace rubble
