#pragma once

#include "core/asset/bake/Bake.h"
#include "core/asset/project/Project.h"
#include "core/structure/clusters/ClusterProposal.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// The bonds between the fragments of a fracture, as a graph: its nodes are the fragments, in order.
BondGraph fractureGraph(const Bake& bake, std::uint32_t fracture);

/// What the clusters of a proposal are to be like.
struct ClusterTarget {
    enum class Measure {
        Number,  // of clusters
        Size,    // of each, in fragments
    };
    static constexpr std::uint32_t kMost = 1'000'000;
    Measure measure = Measure::Number;
    std::uint32_t value = 8;  // from 1 to kMost
};

/// Makes the clusters of an asset's bonds at one level, for the fragments of one fracture. Each function returns all
/// clusters of the asset after a change; the asset stays as it is. Clusters are named by their index in
/// Bonding::clusters; those of other levels and fractures are ignored. A cluster of which one fragment is left, or
/// would be made, is dropped. Paths of fragments that do not exist stay in clusters that are not split.
///
/// Proposed and grown clusters stay within those of the next coarser level that has any there.
class ClusterEditing {
public:
    /// Borrows all; `level` is in the range of ProjectNumber::BondClusterLevel.
    ClusterEditing(const Asset& asset, const Bake& bake, std::uint32_t fracture, std::uint32_t level);

    /// Replaces the level's clusters by proposed ones: in each cluster of the next coarser level a part of the number,
    /// by its size, one at least.
    std::vector<FragmentCluster> propose(const ClusterTarget& target) const;
    /// Makes a cluster of fragments, which leave those that they are in; nodes of the graph, ascending.
    std::vector<FragmentCluster> make(std::span<const std::uint32_t> nodes) const;
    /// Adds to each cluster, one after the other, all its neighbours in none.
    std::vector<FragmentCluster> grow(std::span<const std::uint32_t> clusters) const;
    /// Makes one cluster of several.
    std::vector<FragmentCluster> merge(std::span<const std::uint32_t> clusters) const;
    /// Halves each cluster.
    std::vector<FragmentCluster> split(std::span<const std::uint32_t> clusters) const;
    /// Removes fragments from their clusters.
    std::vector<FragmentCluster> remove(std::span<const std::uint32_t> nodes) const;

    const BondGraph& graph() const { return m_graph; }
    /// The clusters of the level that some nodes are in, ascending.
    std::vector<std::uint32_t> clustersOf(std::span<const std::uint32_t> nodes) const;
    /// The cluster of each node at the next coarser level that has any; all kNone: there is none.
    std::vector<std::uint32_t> coarserClusters() const;
    /// The nodes of a cluster.
    NodeSet nodesOf(std::uint32_t cluster) const;

private:
    FragmentCluster clusterOf(std::span<const std::uint32_t> nodes) const;
    std::vector<FragmentCluster> without(std::span<const std::uint32_t> clusters) const;

    const Asset& m_asset;
    const Bake& m_bake;
    std::uint32_t m_fracture;
    std::uint32_t m_level;
    BondGraph m_graph;
    std::vector<std::vector<std::uint32_t>> m_clusters;  // see clustersOfFragments()
};

}  // namespace rubble
