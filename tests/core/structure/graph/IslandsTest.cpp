#include "core/structure/graph/Islands.h"

#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/structure/BondGraphs.h"

#include <QTest>

using namespace rubble;

namespace {

struct FloodedIsland {
    std::vector<std::uint32_t> nodes;  // ascending
    bool isAnchored = false;
    bool operator==(const FloodedIsland&) const = default;
};

/// By flooding over the list of bonds, without links.
std::vector<FloodedIsland> floodedIslands(const BondGraph& graph, std::span<const BondDamage> damage,
                                          std::vector<std::uint32_t> nodes) {
    std::vector<FloodedIsland> islands;
    while (!nodes.empty()) {
        FloodedIsland island{{nodes.front()}};
        nodes.erase(nodes.begin());
        for (bool hasGrown = true; hasGrown;) {
            hasGrown = false;
            for (std::size_t k = 0; k < graph.bonds.size(); ++k) {
                const Bond& bond = graph.bonds[k];
                if (damage[k] == kBroken) continue;
                for (const auto& [from, to] :
                     {std::pair(bond.first, bond.second), std::pair(bond.second, bond.first)}) {
                    const auto next = std::ranges::find(nodes, to);
                    if (next == nodes.end() || std::ranges::find(island.nodes, from) == island.nodes.end()) continue;
                    island.nodes.push_back(to);
                    nodes.erase(next);
                    hasGrown = true;
                }
            }
        }
        std::ranges::sort(island.nodes);
        for (std::size_t k = 0; k < graph.bonds.size(); ++k) {
            const Bond& bond = graph.bonds[k];
            island.isAnchored |=
                bond.second == kNone && damage[k] != kBroken && std::ranges::binary_search(island.nodes, bond.first);
        }
        islands.push_back(island);
    }
    return islands;
}

std::vector<FloodedIsland> listed(const Islands& islands) {
    std::vector<FloodedIsland> list;
    for (std::uint32_t k = 0; k < islands.count(); ++k)
        list.push_back({{islands[k].nodes.begin(), islands[k].nodes.end()}, islands[k].isAnchored});
    return list;
}

}  // namespace

class IslandsTest : public QObject {
    Q_OBJECT
private slots:
    void anIntactWallIsOneAnchoredIsland() {
        const BondGraph wall = test::wallOfCubes(4, 3);
        const Islands islands = islandsOf(wall, std::vector<BondDamage>(wall.bondCount()), test::allNodes(wall));
        QCOMPARE(islands.count(), 1u);
        QVERIFY(islands[0].isAnchored);
        QVERIFY(std::ranges::equal(islands[0].nodes, test::allNodes(wall)));
    }
    void islandsAfterBreaksAreThoseOfAll() {
        for (std::uint64_t seed = 0; seed < 2000; ++seed) {
            Random random(seed);
            const auto side = [&] { return static_cast<std::uint32_t>(2 + random.below(20)); };
            const BondGraph wall = test::wallOfCubes(side(), side());
            std::vector<BondDamage> damage(wall.bondCount(), kIntact);
            std::vector<std::uint32_t> nodes = test::allNodes(wall);
            for (int hit = 0; hit < 6; ++hit) {
                std::vector<std::uint32_t> broken;
                const auto breakBond = [&](std::uint32_t bond) {
                    if (damage[bond] != kBroken) broken.push_back(bond);
                    damage[bond] = kBroken;
                };
                for (std::uint64_t k = random.below(6); k > 0; --k)
                    breakBond(static_cast<std::uint32_t>(random.below(wall.bondCount())));
                for (std::uint64_t k = random.below(4); k > 0; --k) {
                    for (const BondLink& link : wall.linksOf(nodes[random.below(nodes.size())])) breakBond(link.bond);
                }
                const Islands islands = islandsAfter(wall, damage, nodes, broken);
                const bool isSame = listed(islands) == listed(islandsOf(wall, damage, nodes));
                QVERIFY2(isSame, qPrintable(faultOfSeed(seed, "the islands differ from those of all nodes")));
                std::uint32_t largest = 0;
                for (std::uint32_t k = 1; k < islands.count(); ++k)
                    if (islands[k].nodes.size() > islands[largest].nodes.size()) largest = k;
                nodes.assign(islands[largest].nodes.begin(), islands[largest].nodes.end());
            }
        }
    }
    void brokenBondsSeparate() {
        const BondGraph wall = test::wallOfCubes(2, 3);  // 4 5 over 2 3 over 0 1
        std::vector<BondDamage> damage(wall.bondCount(), kIntact);
        for (const auto& [first, second] : {std::pair(2u, 4u), std::pair(3u, 5u), std::pair(0u, 1u), std::pair(2u, 3u)})
            damage[test::bondAt(wall, first, second)] = kBroken;
        damage[test::bondAt(wall, 1, kNone)] = kBroken;
        damage[test::bondAt(wall, 4, 5)] = kBroken - 1;  // holds still
        const std::vector<FloodedIsland> expected{{{0, 2}, true}, {{1, 3}, false}, {{4, 5}, false}};
        QVERIFY(listed(islandsOf(wall, damage, test::allNodes(wall))) == expected);
    }
    void nodesThatAreNotGivenDoNotConnect() {
        const BondGraph wall = test::wallOfCubes(3, 1);
        const std::vector<std::uint32_t> ends{0, 2};
        const std::vector<FloodedIsland> expected{{{0}, true}, {{2}, true}};
        QVERIFY(listed(islandsOf(wall, std::vector<BondDamage>(wall.bondCount()), ends)) == expected);
    }
    void noNodesHaveNoIslands() {
        const BondGraph wall = test::wallOfCubes(2, 1);
        QCOMPARE(islandsOf(wall, std::vector<BondDamage>(wall.bondCount()), {}).count(), 0u);
    }
    void islandsAreThoseOfAFlood() {
        for (std::uint64_t seed = 0; seed < 10000; ++seed) {
            Random random(seed);
            const BondGraph graph = test::randomBondGraph(random);
            const std::vector<BondDamage> damage = test::randomDamage(random, graph.bonds.size());
            const std::vector<std::uint32_t> nodes = test::randomNodes(random, graph);
            const bool isSame = listed(islandsOf(graph, damage, nodes)) == floodedIslands(graph, damage, nodes);
            QVERIFY2(isSame, qPrintable(faultOfSeed(seed, "the islands differ from those of a flood")));
        }
    }
};

RUBBLE_TEST(IslandsTest)
#include "IslandsTest.moc"
