#include "core/structure/clusters/ClusterProposal.h"

#include "core/base/Assert.h"
#include "core/base/DisjointSets.h"
#include "core/structure/clusters/ClusterBalance.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>

namespace rubble {
namespace {

constexpr int kRounds = 12;  // of Lloyd's iteration; more hardly change sizes

/// Nodes of a graph by their places, so that nothing depends on their numbers.
struct RankedNodes {
    std::vector<std::uint32_t> nodes;                    // by centre
    std::vector<Vec3> centres;                           // m
    std::vector<std::vector<std::uint32_t>> neighbours;  // ranks, ascending
};

RankedNodes rankedNodes(const BondGraph& graph, std::span<const std::uint32_t> nodes) {
    RankedNodes ranked{.nodes = {nodes.begin(), nodes.end()}, .centres = {}, .neighbours = {}};
    std::ranges::sort(ranked.nodes, {}, [&](std::uint32_t node) {
        const Vec3 centre = graph.centres[node];
        return std::tuple(centre.x, centre.y, centre.z, node);
    });
    std::vector<std::uint32_t> rankOf(graph.nodeCount(), kNone);
    for (std::uint32_t rank = 0; rank < ranked.nodes.size(); ++rank) {
        rankOf[ranked.nodes[rank]] = rank;
        ranked.centres.push_back(graph.centres[ranked.nodes[rank]]);
    }
    for (const std::uint32_t node : ranked.nodes) {
        std::vector<std::uint32_t>& neighbours = ranked.neighbours.emplace_back();
        for (const BondLink& link : graph.linksOf(node)) {
            if (link.node != kNone && rankOf[link.node] != kNone) neighbours.push_back(rankOf[link.node]);
        }
        std::ranges::sort(neighbours);
        neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    }
    return ranked;
}

/// The sets of ranks that bonds connect, by smallest rank.
std::vector<std::vector<std::uint32_t>> connectedSets(const RankedNodes& ranked) {
    DisjointSets sets(ranked.nodes.size());
    for (std::uint32_t rank = 0; rank < ranked.nodes.size(); ++rank) {
        for (const std::uint32_t other : ranked.neighbours[rank]) sets.merge(rank, other);
    }
    std::vector<std::vector<std::uint32_t>> all(ranked.nodes.size());
    for (std::uint32_t rank = 0; rank < ranked.nodes.size(); ++rank) all[sets.rootOf(rank)].push_back(rank);
    std::erase_if(all, [](const auto& set) { return set.empty(); });
    return all;
}

/// How many of `count` clusters each set gets: by its size, one at least, the largest for each cluster first.
std::vector<std::uint32_t> countsOf(const std::vector<std::vector<std::uint32_t>>& sets, std::uint32_t count) {
    std::vector<std::uint32_t> counts(sets.size(), 1);
    for (std::size_t given = sets.size(); given < count; ++given) {
        std::size_t most = kNone;
        for (std::size_t k = 0; k < sets.size(); ++k) {
            if (counts[k] == sets[k].size()) continue;
            if (most == kNone || sets[k].size() * counts[most] > sets[most].size() * counts[k]) most = k;
        }
        if (most == kNone) break;
        ++counts[most];
    }
    return counts;
}

/// Parts one set of connected nodes.
class SetPartition {
public:
    SetPartition(const RankedNodes& ranked, std::span<const std::uint32_t> set, std::uint32_t count) {
        std::vector<std::uint32_t> placeOf(ranked.nodes.size(), kNone);
        for (std::uint32_t k = 0; k < set.size(); ++k) placeOf[set[k]] = k;
        for (const std::uint32_t rank : set) {
            m_nodes.centres.push_back(ranked.centres[rank]);
            std::vector<std::uint32_t>& neighbours = m_nodes.neighbours.emplace_back();
            for (const std::uint32_t other : ranked.neighbours[rank]) neighbours.push_back(placeOf[other]);
        }
        m_nodes.count = count;
    }

    /// The cluster of each node.
    std::vector<std::uint32_t> clusters() && {
        std::vector<std::uint32_t> seeds = farthestSeeds();
        for (int round = 0; round < kRounds; ++round) {
            assign(seeds);
            std::vector<std::uint32_t> centred = centralNodes();
            if (centred == seeds) break;
            seeds = std::move(centred);
        }
        assign(seeds);
        balanceClusters(m_nodes);
        return std::move(m_nodes.clusterOf);
    }

private:
    /// The node farthest from the mean, then each the farthest from those before it.
    std::vector<std::uint32_t> farthestSeeds() const {
        const Vec3 sum = std::accumulate(m_nodes.centres.begin(), m_nodes.centres.end(), Vec3(0.0));
        const Vec3 mean = sum / static_cast<double>(m_nodes.centres.size());
        std::vector<double> distances;
        for (const Vec3& centre : m_nodes.centres) distances.push_back(glm::distance(centre, mean));
        std::vector<std::uint32_t> seeds;
        while (seeds.size() < m_nodes.count) {
            const auto farthest = static_cast<std::uint32_t>(std::ranges::max_element(distances) - distances.begin());
            if (seeds.empty()) std::ranges::fill(distances, std::numeric_limits<double>::infinity());
            seeds.push_back(farthest);
            for (std::uint32_t k = 0; k < distances.size(); ++k)
                distances[k] = std::min(distances[k], glm::distance(m_nodes.centres[k], m_nodes.centres[farthest]));
            for (const std::uint32_t seed : seeds) distances[seed] = -1.0;  // also where others are at the same place
        }
        return seeds;
    }

    /// Puts each node into the cluster of the seed that is nearest along bonds.
    void assign(std::span<const std::uint32_t> seeds) {
        using Entry = std::tuple<double, std::uint32_t, std::uint32_t>;  // m, cluster, node
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
        m_nodes.clusterOf.assign(m_nodes.centres.size(), kNone);
        for (std::uint32_t cluster = 0; cluster < seeds.size(); ++cluster) {
            queue.push({0.0, cluster, seeds[cluster]});
            m_nodes.clusterOf[seeds[cluster]] = cluster;  // also where another seed is at the same place
        }
        while (!queue.empty()) {
            const auto [distance, cluster, node] = queue.top();
            queue.pop();
            if (m_nodes.clusterOf[node] != kNone && node != seeds[cluster]) continue;
            m_nodes.clusterOf[node] = cluster;
            for (const std::uint32_t other : m_nodes.neighbours[node]) {
                if (m_nodes.clusterOf[other] != kNone) continue;
                queue.push({distance + glm::distance(m_nodes.centres[node], m_nodes.centres[other]), cluster, other});
            }
        }
    }

    /// The node of each cluster nearest to its mean.
    std::vector<std::uint32_t> centralNodes() const {
        std::vector<Vec3> means(m_nodes.count, Vec3(0.0));
        std::vector<double> sizes(m_nodes.count), least(m_nodes.count, std::numeric_limits<double>::infinity());
        for (std::uint32_t node = 0; node < m_nodes.clusterOf.size(); ++node) {
            means[m_nodes.clusterOf[node]] += m_nodes.centres[node];
            sizes[m_nodes.clusterOf[node]] += 1.0;
        }
        std::vector<std::uint32_t> central(m_nodes.count, kNone);
        for (std::uint32_t node = 0; node < m_nodes.clusterOf.size(); ++node) {
            const std::uint32_t cluster = m_nodes.clusterOf[node];
            const double distance = glm::distance(m_nodes.centres[node], means[cluster] / sizes[cluster]);
            if (!(distance < least[cluster])) continue;
            least[cluster] = distance;
            central[cluster] = node;
        }
        return central;
    }

    ClusteredNodes m_nodes;
};

}  // namespace

std::vector<NodeSet> proposeClusters(const BondGraph& graph, std::span<const std::uint32_t> nodes,
                                     std::uint32_t count) {
    RUBBLE_ASSERT(count >= 1);
    const RankedNodes ranked = rankedNodes(graph, nodes);
    const std::vector<std::vector<std::uint32_t>> sets = connectedSets(ranked);
    const std::vector<std::uint32_t> counts = countsOf(sets, count);
    std::vector<NodeSet> clusters;
    for (std::size_t k = 0; k < sets.size(); ++k) {
        const std::size_t first = clusters.size();
        clusters.resize(first + counts[k]);
        const std::vector<std::uint32_t> clusterOf = SetPartition(ranked, sets[k], counts[k]).clusters();
        for (std::size_t place = 0; place < sets[k].size(); ++place)
            clusters[first + clusterOf[place]].push_back(ranked.nodes[sets[k][place]]);
    }
    for (NodeSet& cluster : clusters) std::ranges::sort(cluster);
    std::ranges::sort(clusters);
    return clusters;
}

std::uint32_t clusterCountOf(std::size_t nodes, std::uint32_t size) {
    return static_cast<std::uint32_t>(std::max<std::size_t>(1, (nodes + size / 2) / size));
}

NodeSet growCluster(const BondGraph& graph, std::span<const std::uint32_t> cluster, const std::vector<bool>& isFree) {
    NodeSet grown(cluster.begin(), cluster.end());
    for (const std::uint32_t node : cluster) {
        for (const BondLink& link : graph.linksOf(node)) {
            if (link.node != kNone && isFree[link.node]) grown.push_back(link.node);
        }
    }
    std::ranges::sort(grown);
    grown.erase(std::unique(grown.begin(), grown.end()), grown.end());
    return grown;
}

NodeSet mergeClusters(std::span<const NodeSet> clusters) {
    NodeSet merged;
    for (const NodeSet& cluster : clusters) merged.insert(merged.end(), cluster.begin(), cluster.end());
    std::ranges::sort(merged);
    return merged;
}

std::vector<NodeSet> splitCluster(const BondGraph& graph, std::span<const std::uint32_t> cluster) {
    return proposeClusters(graph, cluster, 2);
}

}  // namespace rubble
