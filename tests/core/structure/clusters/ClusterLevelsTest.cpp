#include "core/structure/clusters/ClusterLevels.h"

#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/ClusteredRow.h"
#include "tests/support/structure/BondGraphs.h"

#include <QTest>

#include <limits>

using namespace rubble;

namespace {

using Levels = std::vector<ClusterLevel>;
using Nodes = std::vector<std::uint32_t>;

/// The levels of the bonds 0-1, 1-2, … of a row of eight fragments.
Levels levelsOf(const Asset& asset, std::uint32_t fracture = 0) {
    const Bake baked = *bake(asset);
    const BakedFracture& one = baked.fractures[fracture];
    return clusterLevels(asset, baked, fracture, bondsOf(one.fragments, Seeds{.positions = one.seeds.positions}));
}

/// A row of cubes without anchors.
BondGraph rowOfCubes(std::uint32_t count) {
    std::vector<Vec3> centres;
    std::vector<Bond> bonds;
    for (std::uint32_t k = 0; k < count; ++k) centres.emplace_back(k, 0.0, 0.0);
    for (std::uint32_t k = 0; k + 1 < count; ++k) bonds.push_back(test::bondBetween(centres, k, k + 1));
    return bondGraph(std::move(centres), std::move(bonds));
}

}  // namespace

class ClusterLevelsTest : public QObject {
    Q_OBJECT
private slots:
    void withoutClustersThereAreNoLevels() {
        QVERIFY(levelsOf(test::rowOfEight()).empty());
        QVERIFY(levelsOf(test::clusteredRow({{0, {"3.1/4.0", "3.1/4.1"}}})).empty());  // of another fracture
    }
    void bondsWithinAClusterAreDeeper() {
        QCOMPARE(levelsOf(test::clusteredRow({{0, {"3.0", "3.1", "3.2"}}, {0, {"3.3", "3.4"}}})),
                 (Levels{1, 1, 0, 1, 0, 0, 0}));
    }
    void levelsNest() {
        QCOMPARE(levelsOf(test::clusteredRow({{0, {"3.0", "3.1", "3.2", "3.3"}},
                                              {0, {"3.4", "3.5", "3.6", "3.7"}},
                                              {1, {"3.0", "3.1"}},
                                              {1, {"3.4", "3.5", "3.6"}}})),
                 (Levels{2, 1, 1, 0, 2, 2, 1}));
    }
    /// A fragment in no cluster of a level counts with its deeper one there.
    void deeperClustersOfNoneComeOffAsOne() {
        QCOMPARE(levelsOf(test::clusteredRow({{0, {"3.0", "3.1"}}, {1, {"3.4", "3.5"}}})),
                 (Levels{1, 0, 0, 0, 2, 0, 0}));
    }
    void whatLiesAcrossCoarserClustersBreaksWithThem() {
        QCOMPARE(levelsOf(test::clusteredRow({{0, {"3.0", "3.1"}}, {0, {"3.2", "3.3"}}, {1, {"3.1", "3.2"}}})),
                 (Levels{1, 0, 1, 0, 0, 0, 0}));
    }
    void fragmentsThatDoNotExistArePassedOver() {
        QCOMPARE(levelsOf(test::clusteredRow({{0, {"3.0", "3.1", "3.99"}}})), (Levels{1, 0, 0, 0, 0, 0, 0}));
    }
    void fragmentsOfFragmentsHaveClusters() {
        Asset asset = test::clusteredRow({{0, {"3.1/9.0", "3.1/9.1"}}});
        Level halves;
        halves.pattern.layers = {{.id = 9, .parameters = PlacedSeeds{{{0, {-0.25, 0.0}}, {1, {0.25, 0.0}}}}}};
        asset.fragmentLevels = {{"3.1", halves}};
        QVERIFY(levelsOf(asset).empty());
        QCOMPARE(levelsOf(asset, 1), Levels{1});
    }
    void theLeastLevelOfWhatCanBreakBreaks() {
        const BondGraph graph = rowOfCubes(6);
        const Levels levels{2, 0, 1, 0, 1};
        std::vector<double> capacities(5, 1.0);
        std::vector<BondDamage> damage(5, 254);
        const auto level = [&](const Nodes& nodes) {
            return int{breakingLevel(graph, capacities, levels, damage, nodes)};
        };
        const Nodes all = test::allNodes(graph);
        QCOMPARE(level(all), 0);
        QCOMPARE(level({0, 1}), 2);
        QCOMPARE(level({2, 3}), 1);
        QCOMPARE(level({0, 2, 4}), int{kEveryLevel});
        damage[1] = kBroken;
        QCOMPARE(level(all), 0);
        capacities[3] = std::numeric_limits<double>::infinity();
        QCOMPARE(level(all), 1);
        QCOMPARE(int{breakingLevel(graph, capacities, {}, damage, all)}, int{kEveryLevel});
    }
    void anchorsHoldNoLevelBack() {
        const BondGraph graph = test::wallOfCubes(2, 1);  // bonds: the anchor of 0, the one between, that of 1
        const BondGraph ordered = bondGraph(graph.centres, {graph.bonds[1], graph.bonds[0], graph.bonds[2]});
        const std::vector<BondDamage> damage(3, kIntact);
        QCOMPARE(int{breakingLevel(ordered, std::vector(3, 1.0), Levels{3}, damage, Nodes{0, 1})}, 3);
        const Levels levels{3};
        const HeldClusters held{.levels = levels, .breaking = 0};
        QVERIFY(held.holds(0) && !held.holds(1) && !held.holds(2));
    }
    void clustersAreAddedThroughHeldBonds() {
        const BondGraph graph = rowOfCubes(8);
        const Levels levels{1, 2, 1, 0, 1, 1, 1};
        std::vector<BondDamage> damage(7, kIntact);
        const auto added = [&](Nodes nodes, ClusterLevel breaking, const Nodes& body) {
            addClustersOf(nodes, graph, {.levels = levels, .breaking = breaking}, damage, body);
            return nodes;
        };
        const Nodes all = test::allNodes(graph);
        QCOMPARE(added({1}, 0, all), (Nodes{0, 1, 2, 3}));
        QCOMPARE(added({1}, 1, all), (Nodes{1, 2}));
        QCOMPARE(added({3, 7}, 0, all), all);
        QCOMPARE(added({1}, 0, {0, 1, 3}), (Nodes{0, 1}));
        QCOMPARE(added({}, 0, all), Nodes{});
        damage[0] = kBroken;
        QCOMPARE(added({1}, 0, all), (Nodes{1, 2, 3}));
    }
    void clustersAreWholeIfNoOtherNodeIsTheirs() {
        const BondGraph graph = rowOfCubes(6);
        const Levels levels{1, 0, 1, 0, 1};
        const std::vector<BondDamage> damage(5, kIntact);
        const HeldClusters held{.levels = levels, .breaking = 0};
        const Nodes all = test::allNodes(graph);
        QCOMPARE(wholeClusters(Nodes{1, 2, 3, 5}, graph, held, damage, all), (Nodes{2, 3}));
        QCOMPARE(wholeClusters(Nodes{1, 2, 3, 5}, graph, held, damage, Nodes{1, 2, 3, 5}), (Nodes{1, 2, 3, 5}));
        QCOMPARE(wholeClusters(Nodes{1, 2}, graph, {}, damage, all), (Nodes{1, 2}));
    }
};

RUBBLE_TEST(ClusterLevelsTest)
#include "ClusterLevelsTest.moc"
