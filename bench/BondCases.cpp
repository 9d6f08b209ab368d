#include "bench/BondCases.h"

#include "bench/Timing.h"
#include "core/structure/graph/Islands.h"
#include "core/structure/rule/SimpleRule.h"
#include "tests/support/structure/BondGraphs.h"

#include <algorithm>
#include <numeric>

namespace rubble::bench {
namespace {

constexpr std::uint32_t kTowers = 6;          // along each side of the city
constexpr double kTowerSpacing = 8.0;         // m
constexpr double kImpulse = 1e9;              // N·s: of any hit, enough for all bonds of 1 N·s within its radius
constexpr Vec3 kOffCentre{0.31, 0.23, 0.17};  // m: no two bonds are equally far from a hit

struct Structure {
    std::vector<Vec3> centres;
    std::vector<Bond> bonds;

    /// Adds a block of cubes, z by z, with the first centre at `corner`.
    void addBlock(std::uint32_t nx, std::uint32_t ny, std::uint32_t nz, Vec3 corner) {
        const auto first = static_cast<std::uint32_t>(centres.size());
        for (std::uint32_t z = 0; z < nz; ++z)
            for (std::uint32_t y = 0; y < ny; ++y)
                for (std::uint32_t x = 0; x < nx; ++x) centres.push_back(corner + Vec3(x, y, z));
        for (std::uint32_t k = 0; k < nx * ny * nz; ++k) {
            const std::uint32_t node = first + k, x = k % nx, y = k / nx % ny, z = k / (nx * ny);
            if (y == 0) bonds.push_back(test::anchorBelow(centres, node));
            if (x + 1 < nx) bonds.push_back(test::bondBetween(centres, node, node + 1));
            if (y + 1 < ny) bonds.push_back(test::bondBetween(centres, node, node + nx));
            if (z + 1 < nz) bonds.push_back(test::bondBetween(centres, node, node + nx * ny));
        }
    }
};

BondCase caseOf(std::string name, Structure structure, Vec3 hit, double radius) {
    return {std::move(name), bondGraph(std::move(structure.centres), std::move(structure.bonds)), hit + kOffCentre,
            radius};
}

BondCase block(std::string name, std::uint32_t nx, std::uint32_t ny, std::uint32_t nz, double radius) {
    Structure structure;
    structure.addBlock(nx, ny, nz, Vec3(0.0));
    return caseOf(std::move(name), std::move(structure), Vec3(nx / 2, ny / 2, nz / 2), radius);
}

}  // namespace

std::vector<BondCase> bondCases() {
    std::vector<BondCase> cases;
    cases.push_back(block("wall 32 x 32", 32, 32, 1, 4.9));
    cases.push_back(block("wall 100 x 100", 100, 100, 1, 14.9));
    cases.push_back(block("block 22 x 22 x 22", 22, 22, 22, 4.8));
    return cases;
}

BondCase city() {
    Structure structure;
    for (std::uint32_t row = 0; row < kTowers; ++row)
        for (std::uint32_t column = 0; column < kTowers; ++column)
            structure.addBlock(4, 16, 4, kTowerSpacing * Vec3(column, 0.0, row));
    return caseOf("city", std::move(structure), kTowerSpacing * Vec3(2.0, 0.0, 2.0) + Vec3(1.0, 7.0, 1.0), 2.6);
}

BondCase towerOfCity() {
    Structure structure;
    structure.addBlock(4, 16, 4, kTowerSpacing * Vec3(2.0, 0.0, 2.0));
    return caseOf("tower", std::move(structure), kTowerSpacing * Vec3(2.0, 0.0, 2.0) + Vec3(1.0, 7.0, 1.0), 2.6);
}

BondHits::BondHits(const BondCase& bonds)
    : m_case(bonds),
      m_capacities(bonds.graph.bondCount(), 1.0),
      m_owners(bonds.graph.nodeCount(), 0),
      m_nodes(test::allNodes(bonds.graph)),
      m_damage(bonds.graph.bondCount(), kIntact) {}

double BondHits::round() {
    std::ranges::fill(m_damage, kIntact);
    return millisecondsOf([&] {
        const SimpleRule rule{.radius = m_case.radius, .falloff = HitFalloff::Constant};
        const HitOutcome outcome =
            applyHit(m_case.graph, m_capacities, rule, {std::span(&m_case.hit, 1), kImpulse}, m_owners, 0, m_damage);
        m_broken = outcome.broken.size();
        m_islands = islandsOf(m_case.graph, m_damage, m_nodes).count();
    });
}

}  // namespace rubble::bench
