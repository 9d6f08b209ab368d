#include "core/structure/graph/Islands.h"

#include "core/base/Assert.h"

#include <algorithm>
#include <utility>

namespace rubble {
namespace {

std::uint32_t rootOf(std::span<std::uint32_t> parents, std::uint32_t node) {
    while (parents[node] != node) node = parents[node] = parents[parents[node]];
    return node;
}

/// For each node of the graph, a smaller node of its island or, of the smallest, itself; kNone for those not given.
/// Source: union-find with path halving, as DisjointSets, over the given nodes only.
std::vector<std::uint32_t> parentsOf(const BondGraph& graph, std::span<const BondDamage> damage,
                                     std::span<const std::uint32_t> nodes) {
    std::vector<std::uint32_t> parents(graph.nodeCount(), kNone);
    for (const std::uint32_t node : nodes) {
        std::uint32_t root = parents[node] = node;
        for (const BondLink& link : graph.linksOf(node)) {
            // Nodes ascend: a bond is met for the second time at its larger node, when both are known.
            if (link.node >= node || damage[link.bond] == kBroken) continue;
            const std::uint32_t parent = parents[link.node];
            if (parent == root || parent == kNone) continue;  // most neighbours have the root as their parent
            const std::uint32_t other = rootOf(parents, parent);
            parents[std::max(root, other)] = std::min(root, other);
            root = std::min(root, other);
        }
        parents[node] = root;
    }
    return parents;
}

bool hasAnchor(const BondGraph& graph, std::span<const BondDamage> damage, std::uint32_t node) {
    return std::ranges::any_of(
        graph.linksOf(node), [&](const BondLink& link) { return link.node == kNone && damage[link.bond] != kBroken; });
}

/// Numbers the islands by smallest node: replaces each given node's parent by its island, and counts their nodes.
/// Runs of nodes of one island are counted at once.
void numberIslands(std::span<std::uint32_t> parents, std::span<const std::uint32_t> nodes,
                   std::vector<std::uint32_t>& counts) {
    std::uint32_t current = 0, run = 0;
    for (const std::uint32_t node : nodes) {
        const std::uint32_t parent = parents[node];
        const bool isSmallest = parent == node;
        if (isSmallest) counts.push_back(0);
        // A parent is a smaller node, so its island is known.
        const std::uint32_t island = isSmallest ? static_cast<std::uint32_t>(counts.size() - 1) : parents[parent];
        parents[node] = island;
        if (island != current) {
            counts[current] += std::exchange(run, 0u);
            current = island;
        }
        ++run;
    }
    if (run > 0) counts[current] += run;
}

}  // namespace

Islands islandsOf(const BondGraph& graph, std::span<const BondDamage> damage, std::span<const std::uint32_t> nodes) {
    RUBBLE_ASSERT(damage.size() == graph.bonds.size());
    std::vector<std::uint32_t> islandOf = parentsOf(graph, damage, nodes);
    Islands islands;
    std::vector<std::uint32_t> next;
    numberIslands(islandOf, nodes, next);
    islands.firstNode.resize(next.size() + 1);
    for (std::size_t island = 0; island < next.size(); ++island) {
        islands.firstNode[island + 1] = islands.firstNode[island] + next[island];
        next[island] = islands.firstNode[island];
    }
    islands.nodes.resize(nodes.size());
    islands.anchoredFlags.assign(next.size(), 0);
    for (std::size_t k = 0; k < nodes.size();) {
        const std::uint32_t island = islandOf[nodes[k]];
        std::uint32_t place = next[island];
        bool isAnchored = islands.anchoredFlags[island] != 0;
        for (; k < nodes.size() && islandOf[nodes[k]] == island; ++k) {
            islands.nodes[place++] = nodes[k];
            isAnchored = isAnchored || hasAnchor(graph, damage, nodes[k]);
        }
        next[island] = place;
        islands.anchoredFlags[island] = isAnchored ? 1 : 0;
    }
    return islands;
}

}  // namespace rubble
