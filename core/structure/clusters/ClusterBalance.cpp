#include "core/structure/clusters/ClusterBalance.h"

#include "core/base/Index.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <optional>
#include <set>

namespace rubble {
namespace {

/// A move of a node from one cluster to another one that touches it.
using ClusterPair = std::pair<std::uint32_t, std::uint32_t>;

class Balance {
public:
    explicit Balance(ClusteredNodes& nodes) : m_nodes(nodes), m_members(nodes.count), m_sums(nodes.count, Vec3(0.0)) {
        for (std::uint32_t node = 0; node < nodes.clusterOf.size(); ++node) {
            m_members[nodes.clusterOf[node]].insert(node);
            m_sums[nodes.clusterOf[node]] += nodes.centres[node];
        }
    }

    void run() {
        const std::size_t total = m_nodes.clusterOf.size(), count = m_nodes.count;
        const std::size_t least = 3 * total / (4 * count), most = (5 * total + 4 * count - 1) / (4 * count);
        for (bool hasMoved = true; hasMoved;) {
            hasMoved = false;
            for (const std::uint32_t cluster : bySize()) {
                const std::size_t size = m_members[cluster].size();
                if (size > most) hasMoved = shift(cluster, true);
                if (size < least) hasMoved = shift(cluster, false);
                if (hasMoved) break;
            }
        }
    }

private:
    /// The clusters farthest from the mean size first.
    std::vector<std::uint32_t> bySize() const {
        const double mean = static_cast<double>(m_nodes.clusterOf.size()) / m_nodes.count;
        std::vector<std::uint32_t> order(m_nodes.count);
        for (std::uint32_t k = 0; k < order.size(); ++k) order[k] = k;
        std::ranges::stable_sort(order, std::greater(), [&](std::uint32_t cluster) {
            return std::abs(static_cast<double>(m_members[cluster].size()) - mean);
        });
        return order;
    }

    /// Moves one node along each pair of a chain of touching clusters: from `start` to a smaller one, or to it from a
    /// larger one. False if there is no such chain.
    bool shift(std::uint32_t start, bool isGiving) {
        std::set<ClusterPair> blocked;
        while (const auto chain = chainFrom(start, isGiving, blocked)) {
            std::vector<std::pair<std::uint32_t, std::uint32_t>> moved;  // nodes, and where they were
            const auto fails = [&](const ClusterPair& pair) {
                const std::uint32_t node = bestNode(pair);
                if (node == kNone) return true;
                moved.emplace_back(node, pair.first);
                move(node, pair.second);
                return false;
            };
            const auto failed = std::ranges::find_if(*chain, fails);
            if (failed == chain->end()) return true;
            blocked.insert(*failed);
            for (auto back = moved.rbegin(); back != moved.rend(); ++back) move(back->first, back->second);
        }
        return false;
    }

    std::set<std::uint32_t> touching(std::uint32_t cluster) const {
        std::set<std::uint32_t> found;
        for (const std::uint32_t node : m_members[cluster]) {
            for (const std::uint32_t other : m_nodes.neighbours[node]) found.insert(m_nodes.clusterOf[other]);
        }
        found.erase(cluster);
        return found;
    }

    /// The shortest chain of pairs, in the order of moves, to or from the nearest cluster that differs by two nodes.
    std::optional<std::vector<ClusterPair>> chainFrom(std::uint32_t start, bool isGiving,
                                                      const std::set<ClusterPair>& blocked) const {
        std::vector<std::uint32_t> before(m_nodes.count, kNone), queue{start};
        before[start] = start;
        for (std::size_t next = 0; next < queue.size(); ++next) {
            const std::uint32_t from = queue[next];
            const std::size_t size = m_members[from].size(), own = m_members[start].size();
            if (isGiving ? size + 2 <= own : size >= own + 2) return chainTo(from, isGiving, before);
            for (const std::uint32_t other : touching(from)) {
                const ClusterPair pair = isGiving ? ClusterPair{from, other} : ClusterPair{other, from};
                if (before[other] != kNone || blocked.contains(pair)) continue;
                before[other] = from;
                queue.push_back(other);
            }
        }
        return std::nullopt;
    }
    static std::vector<ClusterPair> chainTo(std::uint32_t end, bool isGiving,
                                            const std::vector<std::uint32_t>& before) {
        std::vector<ClusterPair> chain;
        for (std::uint32_t at = end; before[at] != at; at = before[at])
            chain.push_back(isGiving ? ClusterPair{before[at], at} : ClusterPair{at, before[at]});
        if (isGiving) std::ranges::reverse(chain);
        return chain;
    }

    Vec3 meanOf(std::uint32_t cluster) const {
        return m_sums[cluster] / static_cast<double>(m_members[cluster].size());
    }

    /// The node of the first cluster nearest to the second's mean, less its distance from its own, without which the
    /// first stays connected; kNone: there is none.
    std::uint32_t bestNode(const ClusterPair& pair) const {
        const auto [from, to] = pair;
        if (m_members[from].size() < 2) return kNone;
        const Vec3 own = meanOf(from), other = meanOf(to);
        std::vector<std::pair<double, std::uint32_t>> candidates;
        for (const std::uint32_t node : m_members[from]) {
            const auto isOther = [&](std::uint32_t one) { return m_nodes.clusterOf[one] == to; };
            if (!std::ranges::any_of(m_nodes.neighbours[node], isOther)) continue;
            const Vec3 centre = m_nodes.centres[node];
            candidates.emplace_back(glm::distance(centre, other) - glm::distance(centre, own), node);
        }
        std::ranges::sort(candidates);
        for (const auto& [order, node] : candidates) {
            if (staysConnected(from, node)) return node;
        }
        return kNone;
    }

    bool staysConnected(std::uint32_t cluster, std::uint32_t without) const {
        const std::set<std::uint32_t>& members = m_members[cluster];
        const std::uint32_t first = *members.begin() == without ? *std::next(members.begin()) : *members.begin();
        std::set<std::uint32_t> found{without, first};
        std::vector<std::uint32_t> queue{first};
        for (std::size_t next = 0; next < queue.size(); ++next) {
            for (const std::uint32_t other : m_nodes.neighbours[queue[next]]) {
                if (m_nodes.clusterOf[other] == cluster && found.insert(other).second) queue.push_back(other);
            }
        }
        return found.size() == members.size();
    }

    void move(std::uint32_t node, std::uint32_t to) {
        const std::uint32_t from = m_nodes.clusterOf[node];
        m_members[from].erase(node);
        m_members[to].insert(node);
        m_sums[from] -= m_nodes.centres[node];
        m_sums[to] += m_nodes.centres[node];
        m_nodes.clusterOf[node] = to;
    }

    ClusteredNodes& m_nodes;
    std::vector<std::set<std::uint32_t>> m_members;  // of each cluster
    std::vector<Vec3> m_sums;                        // of their centres
};

}  // namespace

void balanceClusters(ClusteredNodes& nodes) {
    if (nodes.count > 1) Balance(nodes).run();
}

}  // namespace rubble
