#pragma once

#include "core/structure/graph/BondGraph.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

using NodeSet = std::vector<std::uint32_t>;  // nodes of a graph, ascending

/// Parts nodes of a graph into `count` >= 1 clusters of nearly the same number of nodes, by first node. Each node is in
/// one cluster, and bonds connect each cluster. There are more clusters where bonds do not
/// connect all nodes, and fewer where there are fewer nodes. Sizes are within a quarter of the mean where the graph
/// allows it: the leaves of a star cannot be parted so.
///
/// The result depends on the centres of nodes, not on the order of nodes and bonds, unless centres are the same.
/// O(nodes · count) and O(bonds) for each node that is moved to balance sizes.
/// Source: farthest-point seeds, Gonzalez 1985; Lloyd 1982, with the distances of Dijkstra 1959 along bonds.
std::vector<NodeSet> proposeClusters(const BondGraph& graph, std::span<const std::uint32_t> nodes, std::uint32_t count);

/// How many clusters of about `size` >= 1 nodes there are to be; one at least.
std::uint32_t clusterCountOf(std::size_t nodes, std::uint32_t size);

/// A cluster and its neighbours that are free, by a flag for each node of the graph.
NodeSet growCluster(const BondGraph& graph, std::span<const std::uint32_t> cluster, const std::vector<bool>& isFree);

/// All nodes of some clusters, which have none in common.
NodeSet mergeClusters(std::span<const NodeSet> clusters);

/// The halves of a cluster, see proposeClusters().
std::vector<NodeSet> splitCluster(const BondGraph& graph, std::span<const std::uint32_t> cluster);

}  // namespace rubble
