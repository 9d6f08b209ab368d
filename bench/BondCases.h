#pragma once

#include "core/structure/graph/BondDamage.h"
#include "core/structure/graph/BondGraph.h"

#include <string>
#include <vector>

namespace rubble::bench {

/// A structure of cubes of 1 m whose lowest are anchored, and a hit that breaks all bonds within a radius.
struct BondCase {
    std::string name;
    BondGraph graph;
    Vec3 hit{0.0};        // m
    double radius = 0.0;  // m
};

/// A wall of 32 x 32, one of 100 x 100, a block of 22 x 22 x 22.
std::vector<BondCase> bondCases();
/// 36 towers of 4 x 4 x 16 in one graph, or the one of them that is hit.
BondCase city();
BondCase towerOfCity();

/// The hit on the intact structure, again and again.
class BondHits {
public:
    explicit BondHits(const BondCase& bonds);
    /// The time of applyHit() and islandsOf(), ms.
    double round();
    std::size_t broken() const { return m_broken; }    // bonds, in the last round
    std::size_t islands() const { return m_islands; }  // in the last round
    std::span<const BondDamage> damage() const { return m_damage; }
    std::span<const std::uint32_t> nodes() const { return m_nodes; }

private:
    const BondCase& m_case;
    std::vector<double> m_capacities;
    std::vector<std::uint32_t> m_owners, m_nodes;
    std::vector<BondDamage> m_damage;
    std::size_t m_broken = 0, m_islands = 0;
};

}  // namespace rubble::bench
