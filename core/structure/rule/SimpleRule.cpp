#include "core/structure/rule/SimpleRule.h"

#include "core/base/Assert.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace rubble {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

/// A bond under a hit.
struct LoadedBond {
    std::uint32_t bond = 0;
    double fraction = 0.0;     // of the impulse
    double utilization = 0.0;  // at the full impulse
    double distance = 0.0;     // m
};

double utilizationOf(double load, double capacity) {
    if (capacity > 0.0) return load / capacity;
    return load > 0.0 ? kInfinite : 0.0;
}

/// The body that is hit.
struct StruckBody {
    const BondGraph& graph;
    std::span<const std::uint32_t> ownerOfNode;
    std::uint32_t owner;
    std::span<const BondDamage> damage;
    const BondHit& hit;

    /// Whether a bond is one of the body that can break.
    bool has(std::uint32_t bond) const {
        if (damage[bond] == kBroken || hit.held.holds(bond)) return false;
        const Bond& joined = graph.bonds[bond];
        return ownerOfNode[joined.first] == owner && (joined.second == kNone || ownerOfNode[joined.second] == owner);
    }
    /// The distance of a bond's centroid from the nearest point, m.
    double distanceOf(Vec3 centroid) const {
        double least = kInfinite;
        for (const Vec3& point : hit.points) least = std::min(least, glm::distance(point, centroid));
        return least;
    }
    std::vector<std::uint32_t> allNodes() const {
        std::vector<std::uint32_t> nodes;
        for (std::uint32_t node = 0; node < ownerOfNode.size(); ++node) {
            if (ownerOfNode[node] == owner) nodes.push_back(node);
        }
        return nodes;
    }
    /// The node that is nearest to each point; none if the body has no nodes.
    std::vector<std::uint32_t> nearestNodes() const {
        constexpr double kMargin = 1.0 + 1e-9;  // for rounding
        struct Nearest {
            double square = kInfinite;  // m²
            std::uint32_t node = kNone;
        };
        Vec3 middle(0.0);
        for (const Vec3& point : hit.points) middle += point / static_cast<double>(hit.points.size());
        double radius = 0.0;
        for (const Vec3& point : hit.points) radius = std::max(radius, glm::distance(point, middle));
        std::vector<Nearest> nearest(hit.points.size());
        double farthest = kInfinite;  // m², from the middle: nodes beyond it are nearest to no point
        for (std::uint32_t node = 0; node < ownerOfNode.size(); ++node) {
            const Vec3 fromMiddle = graph.centres[node] - middle;
            if (ownerOfNode[node] != owner || glm::dot(fromMiddle, fromMiddle) > farthest) continue;
            double most = 0.0;  // m²
            for (std::size_t k = 0; k < nearest.size(); ++k) {
                const Vec3 arm = graph.centres[node] - hit.points[k];
                if (const double square = glm::dot(arm, arm); square < nearest[k].square) nearest[k] = {square, node};
                most = std::max(most, nearest[k].square);
            }
            const double reach = (std::sqrt(most) + radius) * kMargin;
            farthest = reach * reach;
        }
        std::vector<std::uint32_t> nodes;
        for (const Nearest& one : nearest)
            if (one.node != kNone) nodes.push_back(one.node);
        return nodes;
    }
    /// The nodes that are hit, with their clusters, ascending.
    std::vector<std::uint32_t> struckNodes() const {
        std::vector<std::uint32_t> nodes = nearestNodes();
        std::ranges::sort(nodes);
        nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
        if (!hit.held.levels.empty()) addClustersOf(nodes, graph, hit.held, damage, allNodes());
        return nodes;
    }
};

/// The utilization that breaks a bond, see applyHit(): less than 1 if it is damaged.
double breakingUtilization(BondDamage damage, double damageFrom) {
    return damageFrom + (1.0 - damageFrom) * (kBroken - damage) / kBroken;
}

/// Below 1 where nothing broke, and 1 at least where something did: what one bond takes is missing to another, and
/// damage is rounded.
double consistentUtilization(double utilization, bool isAnyBroken) {
    constexpr double kLargestIntact = 1.0 - 1e-9;
    return isAnyBroken ? std::max(utilization, 1.0) : std::min(utilization, kLargestIntact);
}

/// The bonds that may be damaged. `largest`: see HitOutcome::utilization.
std::vector<LoadedBond> loadedBonds(const StruckBody& body, std::span<const double> capacities, const SimpleRule& rule,
                                    double& largest) {
    constexpr double kMargin = 1.0 + 1e-9;  // for the rounding of boxes
    std::vector<LoadedBond> loaded;
    const auto add = [&](std::uint32_t bond, double distance, double fraction) {
        const double utilization = utilizationOf(body.hit.impulse * fraction, capacities[bond]);
        largest = std::max(largest, utilization / breakingUtilization(body.damage[bond], rule.damageFrom));
        if (utilization >= rule.damageFrom) loaded.push_back({bond, fraction, utilization, distance});
    };
    const std::vector<std::uint32_t> struck = body.struckNodes();
    const auto isStruck = [&](std::uint32_t bond) {
        const Bond& joined = body.graph.bonds[bond];
        return std::ranges::binary_search(struck, joined.first) || std::ranges::binary_search(struck, joined.second);
    };
    for (const std::uint32_t node : struck) {
        for (const BondLink& link : body.graph.linksOf(node)) {
            const bool isSecond = link.node < node && std::ranges::binary_search(struck, link.node);
            if (body.has(link.bond) && !isSecond)
                add(link.bond, body.distanceOf(body.graph.bonds[link.bond].centroid), 1.0);
        }
    }
    Box3 box;
    for (const Vec3& point : body.hit.points) box.include(point);
    const Vec3 farthest{rule.radius * kMargin};
    body.graph.centroids.visitOverlapping(
        {box.min - farthest, box.max + farthest}, [&](std::uint32_t bond, const Box3& centroid) {
            // The tree has centroids in order of visits; those beyond the radius need not be read from the bonds.
            const double distance = body.distanceOf(centroid.min), fraction = loadFraction(rule, distance);
            if (fraction > 0.0 && body.has(bond) && !isStruck(bond)) add(bond, distance, fraction);
        });
    std::ranges::sort(loaded, [](const LoadedBond& a, const LoadedBond& b) {
        return std::tuple(-a.utilization, a.distance, a.bond) < std::tuple(-b.utilization, b.distance, b.bond);
    });
    return loaded;
}

/// The damage after a load, see applyHit().
BondDamage damageAfter(BondDamage damage, double utilization, double damageFrom) {
    if (utilization >= 1.0) return kBroken;
    if (utilization < damageFrom) return damage;
    const double increase = (utilization - damageFrom) / (1.0 - damageFrom);
    return static_cast<BondDamage>(std::min(int{kBroken}, damage + static_cast<int>(increase * kBroken)));
}

/// Raises the damage of a bond, and lists the bond as broken or damaged if that changes it. Returns the impulse that it
/// took, N·s.
double raiseDamage(std::uint32_t bond, double capacity, BondDamage after, std::span<BondDamage> damage,
                   HitOutcome& outcome) {
    const BondDamage before = damage[bond];
    if (after == before) return 0.0;
    damage[bond] = after;
    (after == kBroken ? outcome.broken : outcome.damaged).push_back(bond);
    return capacity * (after - before) / kBroken;
}

/// Sorts the bonds of an outcome and makes its utilization agree with them.
void conclude(HitOutcome& outcome) {
    outcome.utilization = consistentUtilization(outcome.utilization, !outcome.broken.empty());
    std::ranges::sort(outcome.broken);
    std::ranges::sort(outcome.damaged);
}

}  // namespace

SimpleRule simpleRuleOf(const Bonding& bonding) { return {bonding.radius, bonding.falloff, bonding.damageFrom}; }

double loadFraction(const SimpleRule& rule, double distance) {
    const double x = distance / rule.radius;
    if (x > 1.0) return 0.0;
    switch (rule.falloff) {
        case HitFalloff::Constant: return 1.0;
        case HitFalloff::Linear: return 1.0 - x;
        case HitFalloff::Smooth: return 1.0 - x * x * (3.0 - 2.0 * x);
    }
    return 0.0;
}

HitOutcome applyHit(const BondGraph& graph, std::span<const double> capacities, const SimpleRule& rule,
                    const BondHit& hit, std::span<const std::uint32_t> ownerOfNode, std::uint32_t owner,
                    std::span<BondDamage> damage) {
    RUBBLE_ASSERT(capacities.size() == graph.bonds.size() && damage.size() == graph.bonds.size());
    RUBBLE_ASSERT(ownerOfNode.size() == graph.nodeCount() && !hit.points.empty());
    HitOutcome outcome;
    double left = hit.impulse;
    for (const LoadedBond& loaded :
         loadedBonds({graph, ownerOfNode, owner, damage, hit}, capacities, rule, outcome.utilization)) {
        const double capacity = capacities[loaded.bond];
        const double utilization = utilizationOf(left * loaded.fraction, capacity);
        const BondDamage after = damageAfter(damage[loaded.bond], utilization, rule.damageFrom);
        left = std::max(0.0, left - raiseDamage(loaded.bond, capacity, after, damage, outcome));
    }
    outcome.taken = hit.impulse - left;
    conclude(outcome);
    return outcome;
}

HitOutcome applyLoads(std::span<const double> capacities, const SimpleRule& rule, std::span<const BondLoad> loads,
                      std::span<BondDamage> damage) {
    RUBBLE_ASSERT(capacities.size() == damage.size());
    HitOutcome outcome;
    for (const auto& [bond, load] : loads) {
        const BondDamage before = damage[bond];
        const double utilization = utilizationOf(load, capacities[bond]);
        const BondDamage after = damageAfter(before, utilization, rule.damageFrom);
        if (before != kBroken)
            outcome.utilization =
                std::max(outcome.utilization, utilization / breakingUtilization(before, rule.damageFrom));
        outcome.taken += raiseDamage(bond, capacities[bond], after, damage, outcome);
    }
    conclude(outcome);
    return outcome;
}

double leastImpulse(std::span<const double> capacities, const SimpleRule& rule) {
    return capacities.empty() ? kInfinite : rule.damageFrom * std::ranges::min(capacities);
}

}  // namespace rubble
