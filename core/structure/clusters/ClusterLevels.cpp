#include "core/structure/clusters/ClusterLevels.h"

#include "core/asset/bake/FragmentLookup.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>

namespace rubble {
namespace {

/// The fragments of a fracture by their paths.
std::map<FragmentPath, std::uint32_t> fragmentsByPath(const Bake& bake, const BakedFracture& baked) {
    std::map<FragmentPath, std::uint32_t> fragments;
    for (std::uint32_t k = 0; k < baked.fragments.count(); ++k) fragments[bake.fragmentPath(baked.first + k)] = k;
    return fragments;
}

/// Where fragments are in no cluster, the numbers of those of the next deeper level; of their own beyond the last.
void addDeeperClusters(std::vector<std::vector<std::uint32_t>>& levels, std::size_t clusterCount) {
    for (std::size_t level = levels.size(); level-- > 0;) {
        for (std::uint32_t k = 0; k < levels[level].size(); ++k) {
            std::uint32_t& cluster = levels[level][k];
            if (cluster != kNone) continue;
            const bool isLast = level + 1 == levels.size();
            cluster = isLast ? static_cast<std::uint32_t>(clusterCount) + k : levels[level + 1][k];
        }
    }
}

}  // namespace

std::vector<std::vector<std::uint32_t>> clustersOfFragments(const Asset& asset, const Bake& bake,
                                                            std::uint32_t fracture) {
    const std::vector<FragmentCluster>& clusters = asset.bonding.clusters;
    if (clusters.empty()) return {};
    const BakedFracture& baked = bake.fractures[fracture];
    const FragmentPath parent = baked.parent == kNone ? FragmentPath() : bake.fragmentPath(baked.parent);
    const std::map<FragmentPath, std::uint32_t> fragments = fragmentsByPath(bake, baked);
    std::vector<std::vector<std::uint32_t>> levels;
    for (std::uint32_t cluster = 0; cluster < clusters.size(); ++cluster) {
        const auto& [level, paths] = clusters[cluster];
        if (parentOf(paths.front()) != parent) continue;
        if (levels.size() <= level) levels.resize(level + 1, std::vector<std::uint32_t>(fragments.size(), kNone));
        for (const FragmentPath& path : paths) {
            if (const auto found = fragments.find(path); found != fragments.end())
                levels[level][found->second] = cluster;
        }
    }
    return levels;
}

std::vector<ClusterLevel> clusterLevels(const Asset& asset, const Bake& bake, std::uint32_t fracture,
                                        std::span<const Bond> bonds) {
    std::vector<std::vector<std::uint32_t>> levels = clustersOfFragments(asset, bake, fracture);
    if (levels.empty()) return {};
    addDeeperClusters(levels, asset.bonding.clusters.size());
    std::vector<ClusterLevel> ofBonds;
    ofBonds.reserve(bonds.size());
    for (const Bond& bond : bonds) {
        const auto parts = [&](const auto& clusters) { return clusters[bond.first] != clusters[bond.second]; };
        ofBonds.push_back(static_cast<ClusterLevel>(std::ranges::find_if(levels, parts) - levels.begin()));
    }
    return ofBonds;
}

ClusterLevel breakingLevel(const BondGraph& graph, std::span<const double> capacities,
                           std::span<const ClusterLevel> levels, std::span<const BondDamage> damage,
                           std::span<const std::uint32_t> nodes) {
    ClusterLevel least = kEveryLevel;
    if (levels.empty()) return least;
    for (const std::uint32_t node : nodes) {
        for (const auto& [other, bond] : graph.linksOf(node)) {
            if (other == kNone || other < node || bond >= levels.size() || levels[bond] >= least) continue;
            if (damage[bond] == kBroken || !std::isfinite(capacities[bond])) continue;
            if (std::ranges::binary_search(nodes, other)) least = levels[bond];
        }
    }
    return least;
}

void addClustersOf(std::vector<std::uint32_t>& nodes, const BondGraph& graph, const HeldClusters& held,
                   std::span<const BondDamage> damage, std::span<const std::uint32_t> body) {
    if (held.levels.empty() || nodes.empty()) return;
    std::vector<bool> isFound(graph.nodeCount(), true);  // also what is not of the body
    for (const std::uint32_t node : body) isFound[node] = false;
    for (const std::uint32_t node : nodes) isFound[node] = true;
    for (std::size_t next = 0; next < nodes.size(); ++next) {
        for (const auto& [other, bond] : graph.linksOf(nodes[next])) {
            if (other == kNone || isFound[other] || damage[bond] == kBroken || !held.holds(bond)) continue;
            isFound[other] = true;
            nodes.push_back(other);
        }
    }
    std::ranges::sort(nodes);
}

std::vector<std::uint32_t> wholeClusters(std::span<const std::uint32_t> nodes, const BondGraph& graph,
                                         const HeldClusters& held, std::span<const BondDamage> damage,
                                         std::span<const std::uint32_t> body) {
    std::vector<std::uint32_t> others, whole;
    std::ranges::set_difference(body, nodes, std::back_inserter(others));
    addClustersOf(others, graph, held, damage, body);
    std::ranges::set_difference(nodes, others, std::back_inserter(whole));
    return whole;
}

}  // namespace rubble
