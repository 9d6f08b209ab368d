#include "core/structure/clusters/ClusterEditing.h"

#include "core/structure/clusters/ClusterLevels.h"

#include <algorithm>
#include <map>

namespace rubble {
namespace {

/// Clusters without those that have become empty.
std::vector<FragmentCluster> inOrder(std::vector<FragmentCluster> clusters) {
    sortClusters(clusters);
    return clusters;
}

}  // namespace

BondGraph fractureGraph(const Bake& bake, std::uint32_t fracture) {
    const BakedFracture& baked = bake.fractures[fracture];
    std::vector<Vec3> centres;
    for (std::uint32_t k = 0; k < baked.fragments.count(); ++k) centres.push_back(baked.fragments[k].offset());
    return bondGraph(std::move(centres), bondsOf(baked));
}

ClusterEditing::ClusterEditing(const Asset& asset, const Bake& bake, std::uint32_t fracture, std::uint32_t level)
    : m_asset(asset),
      m_bake(bake),
      m_fracture(fracture),
      m_level(level),
      m_graph(fractureGraph(bake, fracture)),
      m_clusters(clustersOfFragments(asset, bake, fracture)) {
    if (m_clusters.size() <= level)
        m_clusters.resize(level + 1, std::vector<std::uint32_t>(m_graph.nodeCount(), kNone));
}

std::vector<FragmentCluster> ClusterEditing::propose(const ClusterTarget& target) const {
    const std::vector<std::uint32_t> coarser = coarserClusters();
    const bool isWithin = std::ranges::any_of(coarser, [](std::uint32_t cluster) { return cluster != kNone; });
    std::map<std::uint32_t, NodeSet> groups;
    std::size_t all = 0;
    for (std::uint32_t node = 0; node < m_graph.nodeCount(); ++node) {
        if (isWithin && coarser[node] == kNone) continue;
        groups[coarser[node]].push_back(node);
        ++all;
    }
    std::vector<FragmentCluster> made = without(m_clusters[m_level]);
    for (const auto& [cluster, nodes] : groups) {
        const bool isNumber = target.measure == ClusterTarget::Measure::Number;
        const std::size_t share = (nodes.size() * target.value + all / 2) / all;
        const std::uint32_t count = isNumber ? static_cast<std::uint32_t>(std::max<std::size_t>(1, share))
                                             : clusterCountOf(nodes.size(), target.value);
        for (const NodeSet& proposed : proposeClusters(m_graph, nodes, count)) {
            if (proposed.size() > 1) made.push_back(clusterOf(proposed));
        }
    }
    return inOrder(std::move(made));
}

std::vector<FragmentCluster> ClusterEditing::make(std::span<const std::uint32_t> nodes) const {
    std::vector<FragmentCluster> made = remove(nodes);
    if (nodes.size() > 1) made.push_back(clusterOf(nodes));
    return inOrder(std::move(made));
}

std::vector<FragmentCluster> ClusterEditing::grow(std::span<const std::uint32_t> clusters) const {
    const std::vector<std::uint32_t> coarser = coarserClusters();
    std::vector<bool> isFree;
    for (const std::uint32_t cluster : m_clusters[m_level]) isFree.push_back(cluster == kNone);
    std::vector<FragmentCluster> made = m_asset.bonding.clusters;
    for (const std::uint32_t cluster : clusters) {
        const NodeSet nodes = nodesOf(cluster);
        for (const std::uint32_t node : growCluster(m_graph, nodes, isFree)) {
            if (!isFree[node] || coarser[node] != coarser[nodes.front()]) continue;
            isFree[node] = false;
            made[cluster].fragments.push_back(clusterOf({&node, 1}).fragments.front());
        }
    }
    return inOrder(std::move(made));
}

std::vector<FragmentCluster> ClusterEditing::merge(std::span<const std::uint32_t> clusters) const {
    std::vector<FragmentCluster> made = m_asset.bonding.clusters;
    for (const std::uint32_t cluster : clusters) {
        if (cluster == clusters.front()) continue;
        std::vector<FragmentPath>& into = made[clusters.front()].fragments;
        into.insert(into.end(), made[cluster].fragments.begin(), made[cluster].fragments.end());
        made[cluster].fragments.clear();
    }
    return inOrder(std::move(made));
}

std::vector<FragmentCluster> ClusterEditing::split(std::span<const std::uint32_t> clusters) const {
    std::vector<FragmentCluster> made = without(clusters);
    for (const std::uint32_t cluster : clusters) {
        for (const NodeSet& half : splitCluster(m_graph, nodesOf(cluster))) {
            if (half.size() > 1) made.push_back(clusterOf(half));
        }
    }
    return inOrder(std::move(made));
}

std::vector<FragmentCluster> ClusterEditing::remove(std::span<const std::uint32_t> nodes) const {
    std::vector<FragmentCluster> made = m_asset.bonding.clusters;
    for (const std::uint32_t node : nodes) {
        const std::uint32_t cluster = m_clusters[m_level][node];
        if (cluster != kNone) std::erase(made[cluster].fragments, clusterOf({&node, 1}).fragments.front());
    }
    for (const std::uint32_t cluster : clustersOf(nodes)) {
        if (made[cluster].fragments.size() == 1) made[cluster].fragments.clear();
    }
    return inOrder(std::move(made));
}

std::vector<std::uint32_t> ClusterEditing::clustersOf(std::span<const std::uint32_t> nodes) const {
    std::vector<std::uint32_t> clusters;
    for (const std::uint32_t node : nodes) {
        if (m_clusters[m_level][node] != kNone) clusters.push_back(m_clusters[m_level][node]);
    }
    std::ranges::sort(clusters);
    clusters.erase(std::unique(clusters.begin(), clusters.end()), clusters.end());
    return clusters;
}

NodeSet ClusterEditing::nodesOf(std::uint32_t cluster) const {
    NodeSet nodes;
    for (std::uint32_t node = 0; node < m_graph.nodeCount(); ++node) {
        if (m_clusters[m_level][node] == cluster) nodes.push_back(node);
    }
    return nodes;
}

std::vector<std::uint32_t> ClusterEditing::coarserClusters() const {
    for (std::uint32_t level = m_level; level-- > 0;) {
        if (std::ranges::any_of(m_clusters[level], [](std::uint32_t cluster) { return cluster != kNone; }))
            return m_clusters[level];
    }
    return std::vector<std::uint32_t>(m_graph.nodeCount(), kNone);
}

FragmentCluster ClusterEditing::clusterOf(std::span<const std::uint32_t> nodes) const {
    FragmentCluster cluster{.level = m_level, .fragments = {}};
    for (const std::uint32_t node : nodes)
        cluster.fragments.push_back(m_bake.fragmentPath(m_bake.fractures[m_fracture].first + node));
    return cluster;
}

std::vector<FragmentCluster> ClusterEditing::without(std::span<const std::uint32_t> clusters) const {
    std::vector<FragmentCluster> made = m_asset.bonding.clusters;
    for (const std::uint32_t cluster : clusters) {
        if (cluster != kNone) made[cluster].fragments.clear();
    }
    return made;
}

}  // namespace rubble
