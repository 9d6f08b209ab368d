#include "core/structure/graph/Islands.h"

#include "core/base/Assert.h"
#include "core/base/DisjointSets.h"

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

/// Searches from the ends of bonds, all at once and a node each in turn, until all but one have found their islands.
class IslandSearch {
public:
    IslandSearch(const BondGraph& graph, std::span<const BondDamage> damage, std::span<const std::uint32_t> nodes,
                 std::span<const std::uint32_t> broken)
        : m_graph(graph), m_damage(damage), m_searchOf(graph.nodeCount(), kNone), m_sets(2 * broken.size()) {
        m_reached.reserve(2 * broken.size());
        for (const std::uint32_t bond : broken) {
            for (const std::uint32_t node : {graph.bonds[bond].first, graph.bonds[bond].second}) {
                if (node == kNone || m_searchOf[node] != kNone || !std::ranges::binary_search(nodes, node)) continue;
                m_searchOf[node] = static_cast<std::uint32_t>(m_reached.size());
                m_reached.push_back({node});
            }
        }
        m_next.assign(m_reached.size(), 0);
    }

    /// The islands that were found, each with its nodes in any order. All other nodes are one island more.
    std::vector<std::vector<std::uint32_t>> found() && {
        std::vector<std::uint32_t> searching(m_reached.size());
        for (std::uint32_t k = 0; k < searching.size(); ++k) searching[k] = k;
        std::vector<std::vector<std::uint32_t>> islands;
        while (searching.size() > 1) {
            std::size_t kept = 0;
            for (const std::uint32_t search : searching) {
                if (m_sets.rootOf(search) != search) continue;
                if (m_next[search] == m_reached[search].size()) {
                    islands.push_back(std::move(m_reached[search]));
                    continue;
                }
                visitNext(search);
                searching[kept++] = search;
            }
            searching.resize(kept);
        }
        return islands;
    }

private:
    void visitNext(std::uint32_t search) {
        const std::uint32_t node = m_reached[search][m_next[search]++];
        for (const BondLink& link : m_graph.linksOf(node)) {
            if (link.node == kNone || m_damage[link.bond] == kBroken) continue;
            const std::uint32_t owner = m_searchOf[link.node];
            if (owner == kNone) {
                m_searchOf[link.node] = search;
                m_reached[search].push_back(link.node);
            } else if (const std::uint32_t other = m_sets.rootOf(owner); other != search) {
                join(search, other);
            }
        }
    }
    /// Has a search take over another one, whose visited nodes come first.
    void join(std::uint32_t search, std::uint32_t other) {
        m_sets.mergeInto(search, other);
        std::vector<std::uint32_t>&own = m_reached[search], &its = m_reached[other];
        if (own.size() < its.size()) {
            std::swap(own, its);
            std::swap(m_next[search], m_next[other]);
        }
        const auto visited = own.begin() + static_cast<std::ptrdiff_t>(m_next[search]);
        const auto itsVisited = its.begin() + static_cast<std::ptrdiff_t>(m_next[other]);
        own.insert(visited, its.begin(), itsVisited);
        own.insert(own.end(), itsVisited, its.end());
        m_next[search] += m_next[other];
        its = {};
    }

    const BondGraph& m_graph;
    std::span<const BondDamage> m_damage;
    std::vector<std::uint32_t> m_searchOf;              // of each node that was reached
    std::vector<std::vector<std::uint32_t>> m_reached;  // by search: its nodes, those that were visited first
    std::vector<std::size_t> m_next;                    // by search: the first that was not
    DisjointSets m_sets;                                // of searches that met
};

}  // namespace

Islands islandsAfter(const BondGraph& graph, std::span<const BondDamage> damage, std::span<const std::uint32_t> nodes,
                     std::span<const std::uint32_t> broken) {
    constexpr std::size_t kMinNodesPerBond = 8;  // with fewer, the searches would meet everywhere
    if (kMinNodesPerBond * broken.size() > nodes.size()) return islandsOf(graph, damage, nodes);
    std::vector<std::vector<std::uint32_t>> islands = IslandSearch(graph, damage, nodes, broken).found();
    std::vector<std::uint8_t> isFound(graph.nodeCount(), 0);
    std::size_t foundCount = 0;
    for (std::vector<std::uint32_t>& island : islands) {
        std::ranges::sort(island);
        foundCount += island.size();
        for (const std::uint32_t node : island) isFound[node] = 1;
    }
    if (foundCount < nodes.size()) {
        std::vector<std::uint32_t>& rest = islands.emplace_back(nodes.size() - foundCount + 1);
        std::size_t count = 0;  // written unconditionally, kept by counting
        for (const std::uint32_t node : nodes) {
            rest[count] = node;
            count += isFound[node] == 0 ? 1 : 0;
        }
        rest.resize(count);
    }
    std::ranges::sort(islands, {}, [](const std::vector<std::uint32_t>& island) { return island.front(); });
    Islands all;
    all.nodes.reserve(nodes.size());
    all.firstNode.push_back(0);
    for (const std::vector<std::uint32_t>& island : islands) {
        all.nodes.insert(all.nodes.end(), island.begin(), island.end());
        all.firstNode.push_back(static_cast<std::uint32_t>(all.nodes.size()));
        const auto holds = [&](std::uint32_t node) { return hasAnchor(graph, damage, node); };
        all.anchoredFlags.push_back(std::ranges::any_of(island, holds) ? 1 : 0);
    }
    return all;
}

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
