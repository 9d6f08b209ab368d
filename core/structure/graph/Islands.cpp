#include "core/structure/graph/Islands.h"

#include "core/base/Assert.h"

#include <algorithm>

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
            if (link.node >= node || damage[link.bond] == kBroken || parents[link.node] == kNone) continue;
            const std::uint32_t other = rootOf(parents, link.node);
            parents[std::max(root, other)] = std::min(root, other);
            root = std::min(root, other);
        }
    }
    return parents;
}

bool hasAnchor(const BondGraph& graph, std::span<const BondDamage> damage, std::uint32_t node) {
    return std::ranges::any_of(
        graph.linksOf(node), [&](const BondLink& link) { return link.node == kNone && damage[link.bond] != kBroken; });
}

}  // namespace

Islands islandsOf(const BondGraph& graph, std::span<const BondDamage> damage, std::span<const std::uint32_t> nodes) {
    RUBBLE_ASSERT(damage.size() == graph.bonds.size());
    std::vector<std::uint32_t> parents = parentsOf(graph, damage, nodes);
    Islands islands;
    std::vector<std::uint32_t> islandOf(nodes.size());
    islands.firstNode.push_back(0);
    // A parent is a smaller node, so its island is known: from here on `parents` holds islands.
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        const std::uint32_t node = nodes[k];
        const bool isSmallest = parents[node] == node;
        if (isSmallest) islands.firstNode.push_back(0);
        const auto newest = static_cast<std::uint32_t>(islands.firstNode.size() - 2);
        islandOf[k] = parents[node] = isSmallest ? newest : parents[parents[node]];
        ++islands.firstNode[islandOf[k] + 1];
    }
    const std::size_t count = islands.firstNode.size() - 1;
    for (std::size_t island = 1; island <= count; ++island) islands.firstNode[island] += islands.firstNode[island - 1];
    islands.nodes.resize(nodes.size());
    islands.anchoredFlags.assign(count, 0);
    std::vector<std::uint32_t> next(islands.firstNode.begin(), islands.firstNode.end() - 1);
    for (std::size_t k = 0; k < nodes.size(); ++k) {
        islands.nodes[next[islandOf[k]]++] = nodes[k];
        if (islands.anchoredFlags[islandOf[k]] == 0 && hasAnchor(graph, damage, nodes[k]))
            islands.anchoredFlags[islandOf[k]] = 1;
    }
    return islands;
}

}  // namespace rubble
