// Tests core/structure/clusters/ClusterProposal.cpp and core/structure/clusters/ClusterBalance.cpp.
#include "core/structure/clusters/ClusterProposal.h"

#include "core/base/DisjointSets.h"
#include "core/structure/clusters/ClusterBalance.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/structure/BondGraphs.h"

#include <QTest>

#include <set>

using namespace rubble;

namespace {

/// The number of sets of nodes that bonds between them connect.
std::size_t partsOf(const BondGraph& graph, const NodeSet& nodes) {
    DisjointSets sets(graph.nodeCount());
    for (const Bond& bond : graph.bonds) {
        if (bond.second == kNone) continue;
        if (std::ranges::binary_search(nodes, bond.first) && std::ranges::binary_search(nodes, bond.second))
            sets.merge(bond.first, bond.second);
    }
    std::set<std::uint32_t> roots;
    for (const std::uint32_t node : nodes) roots.insert(sets.rootOf(node));
    return roots.size();
}

/// What is wrong with clusters of some nodes; empty: nothing.
std::string faultOf(const BondGraph& graph, const NodeSet& nodes, std::uint32_t count,
                    const std::vector<NodeSet>& clusters) {
    NodeSet all;
    for (const NodeSet& cluster : clusters) {
        if (cluster.empty() || !std::ranges::is_sorted(cluster)) return "a cluster is empty or out of order";
        if (partsOf(graph, cluster) != 1) return "a cluster is not connected";
        all.insert(all.end(), cluster.begin(), cluster.end());
    }
    if (!std::ranges::is_sorted(clusters)) return "clusters are out of order";
    std::ranges::sort(all);
    if (all != nodes) return "a node is in no cluster, or in two";
    const std::size_t expected = std::min(nodes.size(), std::max(partsOf(graph, nodes), std::size_t{count}));
    return clusters.size() == expected ? "" : "another number of clusters";
}

/// A wall of up to 20 x 20 cubes that are shifted at random.
BondGraph randomWall(Random& random) {
    const auto columns = static_cast<std::uint32_t>(2 + random.below(19));
    const BondGraph cubes = test::wallOfCubes(columns, static_cast<std::uint32_t>(2 + random.below(19)));
    std::vector<Vec3> centres = cubes.centres;
    for (Vec3& centre : centres)
        centre += Vec3{random.between(-0.4, 0.4), random.between(-0.4, 0.4), random.between(-0.1, 0.1)};
    return bondGraph(std::move(centres), cubes.bonds);
}

std::set<std::set<std::tuple<double, double, double>>> placesOf(const BondGraph& graph,
                                                                const std::vector<NodeSet>& clusters) {
    std::set<std::set<std::tuple<double, double, double>>> places;
    for (const NodeSet& cluster : clusters) {
        std::set<std::tuple<double, double, double>> one;
        for (const std::uint32_t node : cluster) {
            const Vec3 centre = graph.centres[node];
            one.insert({centre.x, centre.y, centre.z});
        }
        places.insert(one);
    }
    return places;
}

/// The same graph with its nodes and bonds in a random order.
BondGraph shuffled(Random& random, const BondGraph& graph) {
    std::vector<std::uint32_t> order = test::allNodes(graph);
    std::vector<Bond> bonds = graph.bonds;
    for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[random.below(k)]);
    for (std::size_t k = bonds.size(); k > 1; --k) std::swap(bonds[k - 1], bonds[random.below(k)]);
    std::vector<Vec3> centres(order.size());
    for (std::uint32_t node = 0; node < order.size(); ++node) centres[order[node]] = graph.centres[node];
    for (Bond& bond : bonds) {
        bond.first = order[bond.first];
        if (bond.second == kNone) continue;
        bond.second = order[bond.second];
        if (bond.first > bond.second) std::swap(bond.first, bond.second), bond.normal = -bond.normal;
    }
    return bondGraph(std::move(centres), std::move(bonds));
}

}  // namespace

class ClusterProposalTest : public QObject {
    Q_OBJECT
private slots:
    void rowIsHalved() {
        const BondGraph graph = test::wallOfCubes(8, 1);
        QCOMPARE(proposeClusters(graph, test::allNodes(graph), 2), (std::vector<NodeSet>{{0, 1, 2, 3}, {4, 5, 6, 7}}));
        QCOMPARE(splitCluster(graph, NodeSet{0, 1, 2, 3}), (std::vector<NodeSet>{{0, 1}, {2, 3}}));
        QCOMPARE(splitCluster(graph, NodeSet{5}), (std::vector<NodeSet>{{5}}));
        QCOMPARE(splitCluster(graph, NodeSet{0, 1, 6, 7}), (std::vector<NodeSet>{{0, 1}, {6, 7}}));
    }
    void squareIsQuartered() {
        const BondGraph graph = test::wallOfCubes(10, 10);
        const std::vector<NodeSet> quarters = proposeClusters(graph, test::allNodes(graph), 4);
        QCOMPARE(faultOf(graph, test::allNodes(graph), 4, quarters), std::string());
        for (const NodeSet& quarter : quarters) {
            Box3 box;
            for (const std::uint32_t node : quarter) box.include(graph.centres[node]);
            const Vec3 size = box.max - box.min;  // 4 m each if they were squares
            QVERIFY(quarter.size() >= 18 && quarter.size() <= 32 && size.x <= 7.0 && size.y <= 7.0);
        }
    }
    void thereAreNoMoreClustersThanNodes() {
        const BondGraph graph = test::wallOfCubes(3, 1);
        QCOMPARE(proposeClusters(graph, test::allNodes(graph), 9), (std::vector<NodeSet>{{0}, {1}, {2}}));
        QCOMPARE(proposeClusters(graph, {}, 3), std::vector<NodeSet>{});
        QCOMPARE(proposeClusters(graph, NodeSet{0, 2}, 1), (std::vector<NodeSet>{{0}, {2}}));  // not connected
    }
    void nodesAtTheSamePlaceAreParted() {
        std::vector<Vec3> centres(4, Vec3(1.0));
        std::vector<Bond> bonds;
        for (std::uint32_t k = 0; k < 3; ++k) bonds.push_back({.first = k, .second = k + 1, .area = 1.0});
        const BondGraph graph = bondGraph(centres, bonds);
        const std::vector<NodeSet> clusters = proposeClusters(graph, test::allNodes(graph), 2);
        QCOMPARE(faultOf(graph, test::allNodes(graph), 2, clusters), std::string());
    }
    void sizesGiveCounts() {
        QCOMPARE(clusterCountOf(100, 10), 10u);
        QCOMPARE(clusterCountOf(104, 10), 10u);
        QCOMPARE(clusterCountOf(105, 10), 11u);
        QCOMPARE(clusterCountOf(3, 10), 1u);
        QCOMPARE(clusterCountOf(0, 1), 1u);
    }
    void randomGraphsArePartedWhole() {
        for (std::uint64_t seed = 0; seed < 4000; ++seed) {
            Random random(seed);
            const BondGraph graph = test::randomBondGraph(random);
            const NodeSet nodes = test::randomNodes(random, graph);
            const auto count = static_cast<std::uint32_t>(1 + random.below(12));
            const std::string fault = faultOf(graph, nodes, count, proposeClusters(graph, nodes, count));
            QVERIFY2(fault.empty(), qPrintable(faultOfSeed(seed, fault)));
        }
    }
    /// Shifted cubes: a graph as that of the fragments of a wall.
    void clustersOfWallsHaveNearlyTheSameSize() {
        double largest = 0.0, smallest = 1e9;
        for (std::uint64_t seed = 0; seed < 1000; ++seed) {
            Random random(seed);
            const BondGraph wall = randomWall(random);
            const NodeSet nodes = test::allNodes(wall);
            const auto count = static_cast<std::uint32_t>(1 + random.below(1 + nodes.size() / 4));
            const std::vector<NodeSet> clusters = proposeClusters(wall, nodes, count);
            const std::string fault = faultOf(wall, nodes, count, clusters);
            QVERIFY2(fault.empty(), qPrintable(faultOfSeed(seed, fault)));
            const double mean = static_cast<double>(nodes.size()) / count;
            for (const NodeSet& cluster : clusters) {
                const auto size = static_cast<double>(cluster.size());
                QVERIFY2(size <= std::ceil(1.25 * mean) && size >= std::floor(0.75 * mean),
                         qPrintable(faultOfSeed(seed, "a cluster is too large or small")));
                largest = std::max(largest, size / mean);
                smallest = std::min(smallest, size / mean);
            }
        }
        qInfo("sizes are from %.2f to %.2f times the mean", smallest, largest);
    }
    void orderOfNodesAndBondsDoesNotMatter() {
        for (std::uint64_t seed = 0; seed < 500; ++seed) {
            Random random(seed);
            const BondGraph wall = randomWall(random);
            const NodeSet nodes = test::allNodes(wall);
            const auto count = static_cast<std::uint32_t>(1 + random.below(20));
            const BondGraph other = shuffled(random, wall);
            const auto ofOne = placesOf(wall, proposeClusters(wall, nodes, count));
            const auto ofOther = placesOf(other, proposeClusters(other, nodes, count));
            QVERIFY2(ofOne == ofOther, qPrintable(faultOfSeed(seed, "the order matters")));
        }
    }
    void clustersGrowByFreeNeighbours() {
        const BondGraph graph = test::wallOfCubes(4, 2);  // 4 to 7 above 0 to 3
        std::vector<bool> isFree(8, true);
        isFree[0] = isFree[6] = false;
        QCOMPARE(growCluster(graph, NodeSet{0}, isFree), (NodeSet{0, 1, 4}));
        QCOMPARE(growCluster(graph, NodeSet{2}, isFree), (NodeSet{1, 2, 3}));
    }
    void clustersMerge() {
        QCOMPARE(mergeClusters(std::vector<NodeSet>{{2, 7}, {1}, {3, 5}}), (NodeSet{1, 2, 3, 5, 7}));
    }
    /// A hub with leaves cannot be parted but into single leaves and the rest.
    void starStaysConnected() {
        ClusteredNodes star{.centres = std::vector<Vec3>(9, Vec3(0.0)),
                            .neighbours = std::vector<std::vector<std::uint32_t>>(9, {0}),
                            .clusterOf = {0, 0, 0, 0, 0, 0, 0, 0, 1},
                            .count = 2};
        star.neighbours[0] = {1, 2, 3, 4, 5, 6, 7, 8};
        for (std::uint32_t leaf = 1; leaf < 9; ++leaf) star.centres[leaf] = {leaf, 1.0, 0.0};
        balanceClusters(star);
        QCOMPARE(star.clusterOf, (std::vector<std::uint32_t>{0, 0, 0, 0, 0, 0, 0, 0, 1}));
    }
    /// A row whose clusters differ by chance: nodes move on along the chain of clusters.
    void nodesMoveAlongChainsOfClusters() {
        ClusteredNodes row{.centres = {}, .neighbours = {}, .clusterOf = {}, .count = 4};
        for (std::uint32_t node = 0; node < 16; ++node) {
            row.centres.emplace_back(node, 0.0, 0.0);
            row.neighbours.emplace_back();
            if (node > 0) row.neighbours.back().push_back(node - 1);
            if (node < 15) row.neighbours.back().push_back(node + 1);
            row.clusterOf.push_back(node < 9 ? 0u : node < 13 ? 1u : node < 15 ? 2u : 3u);
        }
        balanceClusters(row);
        std::vector<std::size_t> sizes(4);
        for (const std::uint32_t cluster : row.clusterOf) ++sizes[cluster];
        for (const std::size_t size : sizes) QVERIFY(size >= 3 && size <= 5);
        QVERIFY(std::ranges::is_sorted(row.clusterOf));
    }
};

RUBBLE_TEST(ClusterProposalTest)
#include "ClusterProposalTest.moc"
