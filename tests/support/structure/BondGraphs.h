#pragma once

#include "core/base/Random.h"
#include "core/structure/graph/BondDamage.h"
#include "core/structure/graph/BondGraph.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <numeric>

namespace rubble::test {

/// A bond of 1 m² halfway between two nodes.
inline Bond bondBetween(std::span<const Vec3> centres, std::uint32_t first, std::uint32_t second) {
    const Vec3 apart = centres[second] - centres[first];
    return {.first = std::min(first, second),
            .second = std::max(first, second),
            .area = 1.0,
            .centroid = centres[first] + apart / 2.0,
            .normal = glm::normalize(first < second ? apart : -apart),
            .seedDistance = glm::length(apart)};
}

/// A bond of 1 m² that holds a node from below.
inline Bond anchorBelow(std::span<const Vec3> centres, std::uint32_t node) {
    return {.first = node,
            .area = 1.0,
            .centroid = centres[node] - Vec3{0.0, 0.5, 0.0},
            .normal = {0.0, -1.0, 0.0},
            .seedDistance = 0.5};
}

/// A wall of cubes of 1 m, row by row from the lowest, which is anchored; y is up, and the first centre at the origin.
inline BondGraph wallOfCubes(std::uint32_t columns, std::uint32_t rows) {
    std::vector<Vec3> centres;
    for (std::uint32_t row = 0; row < rows; ++row)
        for (std::uint32_t column = 0; column < columns; ++column) centres.emplace_back(column, row, 0.0);
    std::vector<Bond> bonds;
    for (std::uint32_t node = 0; node < centres.size(); ++node) {
        if (node < columns) bonds.push_back(anchorBelow(centres, node));
        if ((node + 1) % columns > 0) bonds.push_back(bondBetween(centres, node, node + 1));
        if (node + columns < centres.size()) bonds.push_back(bondBetween(centres, node, node + columns));
    }
    return bondGraph(std::move(centres), std::move(bonds));
}

/// Up to 40 nodes in a cube of 10 m with random bonds and anchors, several of some pairs among them.
inline BondGraph randomBondGraph(Random& random) {
    std::vector<Vec3> centres(1 + random.below(40));
    for (Vec3& centre : centres)
        centre = {random.between(0.0, 10.0), random.between(0.0, 10.0), random.between(0.0, 10.0)};
    std::vector<Bond> bonds;
    for (std::uint64_t wanted = random.below(2 * centres.size() + 1); wanted > 0; --wanted) {
        const auto first = static_cast<std::uint32_t>(random.below(centres.size()));
        const auto second = static_cast<std::uint32_t>(random.below(centres.size()));
        if (random.below(8) == 0) bonds.push_back(anchorBelow(centres, first));
        if (first != second) bonds.push_back(bondBetween(centres, first, second));
    }
    return bondGraph(std::move(centres), std::move(bonds));
}

/// Intact, partly damaged and broken bonds.
inline std::vector<BondDamage> randomDamage(Random& random, std::size_t bonds) {
    std::vector<BondDamage> damage(bonds, kIntact);
    const std::uint64_t broken = random.below(10);
    for (BondDamage& one : damage) {
        if (random.below(10) < broken)
            one = kBroken;
        else if (random.below(3) == 0)
            one = static_cast<BondDamage>(random.below(kBroken));
    }
    return damage;
}

inline std::vector<std::uint32_t> allNodes(const BondGraph& graph) {
    std::vector<std::uint32_t> nodes(graph.nodeCount());
    std::iota(nodes.begin(), nodes.end(), 0u);
    return nodes;
}

/// Most of the nodes, half of them, or all.
inline std::vector<std::uint32_t> randomNodes(Random& random, const BondGraph& graph) {
    const std::uint64_t omitted = random.below(4);
    std::vector<std::uint32_t> nodes = allNodes(graph);
    std::erase_if(nodes, [&](std::uint32_t) { return random.below(6) < omitted; });
    return nodes;
}

/// The bond between two nodes; kNone as the second: the first one's to an anchor.
inline std::uint32_t bondAt(const BondGraph& graph, std::uint32_t first, std::uint32_t second) {
    const auto found = std::ranges::find_if(
        graph.bonds, [&](const Bond& bond) { return bond.first == first && bond.second == second; });
    return static_cast<std::uint32_t>(found - graph.bonds.begin());
}

}  // namespace rubble::test
