#pragma once

#include "core/asset/bake/Bake.h"
#include "core/asset/project/Project.h"
#include "core/structure/graph/BondDamage.h"
#include "core/structure/graph/BondGraph.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// A level of clusters at which bonds break: 0, the coarsest, first.
using ClusterLevel = std::uint8_t;
inline constexpr ClusterLevel kEveryLevel = 255;  // deeper than any

/// The cluster of each fragment of a fracture at each level: an index in Bonding::clusters, kNone for none. As many
/// levels as the clusters of the fracture have; none without any. Fragments that do not exist are passed over.
std::vector<std::vector<std::uint32_t>> clustersOfFragments(const Asset& asset, const Bake& bake,
                                                            std::uint32_t fracture);

/// The cluster level of each bond of a fracture: the coarsest level at which its ends are not in the same cluster; the
/// number of levels if they are in the same in all. A fragment that is in no cluster of a level counts there as part of
/// its cluster of the next deeper level that it is in one of. Empty if the fracture has no clusters. `bonds`: between
/// fragments.
std::vector<ClusterLevel> clusterLevels(const Asset& asset, const Bake& bake, std::uint32_t fracture,
                                        std::span<const Bond> bonds);

/// The bonds of a body that hold until those of coarser levels have broken.
struct HeldClusters {
    std::span<const ClusterLevel> levels;  // of the first bonds of a graph; those behind them never hold back
    ClusterLevel breaking = kEveryLevel;   // the level at which the body breaks

    bool holds(std::uint32_t bond) const { return bond < levels.size() && levels[bond] > breaking; }
};

/// The level at which a body breaks: the least of the unbroken bonds between its nodes that can break, by `capacities`;
/// kEveryLevel without such. `nodes`: ascending. O(m log n) in the nodes and their bonds; O(1) without levels.
ClusterLevel breakingLevel(const BondGraph& graph, std::span<const double> capacities,
                           std::span<const ClusterLevel> levels, std::span<const BondDamage> damage,
                           std::span<const std::uint32_t> nodes);

/// Adds to nodes all those of `body` that held bonds connect with them: the rest of their clusters. Both ascending.
void addClustersOf(std::vector<std::uint32_t>& nodes, const BondGraph& graph, const HeldClusters& held,
                   std::span<const BondDamage> damage, std::span<const std::uint32_t> body);

/// Of some nodes of a body, those whose clusters have no other node: all of one that held bonds connect. All ascending.
std::vector<std::uint32_t> wholeClusters(std::span<const std::uint32_t> nodes, const BondGraph& graph,
                                         const HeldClusters& held, std::span<const BondDamage> damage,
                                         std::span<const std::uint32_t> body);

}  // namespace rubble
