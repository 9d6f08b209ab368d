#pragma once

#include "core/geometry/predicates/Vec.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// Connected nodes and the clusters that they are in, of which each is connected.
struct ClusteredNodes {
    std::vector<Vec3> centres;                           // m
    std::vector<std::vector<std::uint32_t>> neighbours;  // of each node
    std::vector<std::uint32_t> clusterOf;                // of each node, below `count`
    std::uint32_t count = 0;                             // of clusters, none of which is empty
};

/// Moves nodes between neighbouring clusters until the sizes of all are within a quarter of the mean, rounded away from
/// it, or no move along clusters that touch brings two of them nearer to each other. Clusters stay connected.
/// O(clusters · log clusters) for each move, and those that it passes.
void balanceClusters(ClusteredNodes& nodes);

}  // namespace rubble
