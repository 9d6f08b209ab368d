#include "core/structure/graph/Support.h"

#include "core/base/Assert.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <utility>

namespace rubble {
namespace {

constexpr double kCorbel = 0.57735026918962576;  // tangent of 30 degrees
constexpr double kUnreached = std::numeric_limits<double>::infinity();
constexpr double kNotGiven = -1.0;

/// Distances from the nearest anchor by node, m; those of nodes that are not given stay below zero.
class AnchorDistances {
public:
    AnchorDistances(const BondGraph& graph, std::span<const BondDamage> damage)
        : m_graph(graph), m_damage(damage), m_distances(graph.nodeCount(), kNotGiven) {}

    /// Lets distances spread over `nodes`, to each up to its limit; without limits, to any distance.
    void spread(std::span<const std::uint32_t> nodes, std::span<const double> limits, Vec3 up) {
        for (const std::uint32_t node : nodes) m_distances[node] = kUnreached;
        for (const std::uint32_t node : nodes) {
            for (const BondLink& link : m_graph.linksOf(node)) {
                if (link.node == kNone && m_damage[link.bond] != kBroken) reach(node, 0.0);
            }
        }
        while (!m_queue.empty()) {
            const auto [distance, node] = m_queue.top();
            m_queue.pop();
            if (distance > m_distances[node]) continue;
            for (const BondLink& link : m_graph.linksOf(node)) {
                if (link.node == kNone || m_damage[link.bond] == kBroken) continue;
                const double reached = distance + sidewaysStep(m_graph, node, link, up);
                if (limits.empty() || reached <= limits[link.node]) reach(link.node, reached);
            }
        }
    }

    double operator[](std::uint32_t node) const { return m_distances[node]; }
    std::vector<double> all() && { return std::move(m_distances); }

private:
    void reach(std::uint32_t node, double distance) {
        if (!(distance < m_distances[node])) return;
        m_distances[node] = distance;
        m_queue.push({distance, node});
    }

    using Entry = std::pair<double, std::uint32_t>;

    const BondGraph& m_graph;
    std::span<const BondDamage> m_damage;
    std::vector<double> m_distances;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> m_queue;
};

}  // namespace

double sidewaysStep(const BondGraph& graph, std::uint32_t from, BondLink link, Vec3 up) {
    const Bond& bond = graph.bonds[link.bond];
    const double upwards = glm::dot(bond.first == from ? bond.normal : -bond.normal, up);
    const Vec3 apart = graph.centres[link.node] - graph.centres[from];
    const double rise = glm::dot(apart, up), sideways = glm::length(apart - rise * up);
    return upwards >= kStandsOn ? std::max(0.0, sideways - kCorbel * rise) : sideways;
}

std::vector<double> anchorDistances(const BondGraph& graph, std::span<const BondDamage> damage, Vec3 up) {
    RUBBLE_ASSERT(damage.size() == graph.bonds.size());
    std::vector<std::uint32_t> nodes(graph.nodeCount());
    std::iota(nodes.begin(), nodes.end(), 0u);
    AnchorDistances distances(graph, damage);
    distances.spread(nodes, {}, up);
    return std::move(distances).all();
}

std::vector<double> supportLimits(const BondGraph& graph, std::span<const BondDamage> atStart, double span, Vec3 up) {
    std::vector<double> limits = anchorDistances(graph, atStart, up);
    const double farthest = span > 0.0 ? span : std::numeric_limits<double>::max();
    for (double& limit : limits) limit = std::max(limit, farthest);
    return limits;
}

std::vector<std::uint32_t> unsupportedNodes(const BondGraph& graph, std::span<const BondDamage> damage,
                                            std::span<const std::uint32_t> nodes, std::span<const double> limits,
                                            Vec3 up) {
    RUBBLE_ASSERT(damage.size() == graph.bonds.size() && limits.size() == graph.nodeCount());
    AnchorDistances distances(graph, damage);
    distances.spread(nodes, limits, up);
    std::vector<std::uint32_t> unsupported;
    for (const std::uint32_t node : nodes) {
        if (distances[node] > limits[node]) unsupported.push_back(node);
    }
    return unsupported;
}

}  // namespace rubble
