#include "core/structure/graph/BondGraph.h"

#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/structure/BondGraphs.h"

#include <QTest>

#include <set>

using namespace rubble;

class BondGraphTest : public QObject {
    Q_OBJECT
private slots:
    void nodesHaveTheirBondsInOrder() {
        const BondGraph wall = test::wallOfCubes(2, 2);  // bonds: 0-anchor, 0-1, 0-2, 1-anchor, 1-3, 2-3
        QCOMPARE(wall.nodeCount(), 4u);
        QCOMPARE(wall.bondCount(), 6u);
        const std::span<const BondLink> ofFirst = wall.linksOf(0);
        QCOMPARE(ofFirst.size(), std::size_t{3});
        QCOMPARE(ofFirst[0].node, kNone);
        QCOMPARE(ofFirst[1].node, 1u);
        QCOMPARE(ofFirst[2].node, 2u);
        QCOMPARE(ofFirst[2].bond, 2u);
        QCOMPARE(wall.linksOf(3).size(), std::size_t{2});
    }
    void everyBondIsALinkOfItsNodes() {
        for (std::uint64_t seed = 0; seed < 200; ++seed) {
            Random random(seed);
            const BondGraph graph = test::randomBondGraph(random);
            std::multiset<std::uint32_t> ends, linked;
            for (const Bond& bond : graph.bonds) {
                ends.insert(bond.first);
                if (bond.second != kNone) ends.insert(bond.second);
            }
            for (std::uint32_t node = 0; node < graph.nodeCount(); ++node) {
                for (const BondLink& link : graph.linksOf(node)) {
                    const Bond& bond = graph.bonds[link.bond];
                    const bool leadsThere = (bond.first == node && bond.second == link.node) ||
                                            (bond.second == node && bond.first == link.node);
                    QVERIFY2(leadsThere, qPrintable(faultOfSeed(seed, "a link leads elsewhere")));
                    linked.insert(node);
                }
            }
            QVERIFY2(ends == linked, qPrintable(faultOfSeed(seed, "a link is missing")));
        }
    }
    void bondsAreFoundByTheirPlace() {
        const BondGraph wall = test::wallOfCubes(3, 2);
        std::vector<std::uint32_t> found;
        wall.centroids.visitOverlapping({{0.9, 0.4, -0.1}, {1.1, 0.6, 0.1}},
                                        [&](std::uint32_t bond) { found.push_back(bond); });
        QCOMPARE(found, std::vector<std::uint32_t>{test::bondAt(wall, 1, 4)});
    }
    void aGraphMayBeEmpty() {
        const BondGraph none = bondGraph({}, {});
        QCOMPARE(none.nodeCount(), 0u);
        QCOMPARE(none.bondCount(), 0u);
    }
};

RUBBLE_TEST(BondGraphTest)
#include "BondGraphTest.moc"
