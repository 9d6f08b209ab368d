#include "core/structure/graph/Support.h"

#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/structure/BondGraphs.h"

#include <QTest>

using namespace rubble;

namespace {

using Nodes = std::vector<std::uint32_t>;

constexpr Vec3 kUp{0.0, 1.0, 0.0};

/// Limits of all nodes by the span alone; 0: any distance.
std::vector<double> limitsOf(const BondGraph& graph, double span) {
    return std::vector<double>(graph.nodeCount(), span > 0.0 ? span : std::numeric_limits<double>::max());
}

std::vector<BondDamage> damageWith(const BondGraph& graph, const Nodes& brokenBonds) {
    std::vector<BondDamage> damage(graph.bondCount(), kIntact);
    for (const std::uint32_t bond : brokenBonds) damage[bond] = kBroken;
    return damage;
}

Nodes unsupported(const BondGraph& graph, double span, const Nodes& brokenBonds = {}) {
    return unsupportedNodes(graph, damageWith(graph, brokenBonds), test::allNodes(graph), limitsOf(graph, span), kUp);
}

/// What bonds that break take the support of, where others are broken from the start.
Nodes losingSupport(const BondGraph& graph, double span, const Nodes& openFromStart, const Nodes& brokenBonds) {
    std::vector<BondDamage> damage = damageWith(graph, openFromStart);
    const std::vector<double> limits = supportLimits(graph, damage, span, kUp);
    for (const std::uint32_t bond : brokenBonds) damage[bond] = kBroken;
    return unsupportedNodes(graph, damage, test::allNodes(graph), limits, kUp);
}

/// The bonds that hold a node from below, and those to its left and right.
Nodes bondsBelow(const BondGraph& graph, const Nodes& nodes, std::uint32_t columns) {
    Nodes bonds;
    for (const std::uint32_t node : nodes)
        bonds.push_back(node < columns ? test::bondAt(graph, node, kNone) : test::bondAt(graph, node - columns, node));
    return bonds;
}

/// By relaxing all bonds until nothing changes.
Nodes relaxedUnsupported(const BondGraph& graph, std::span<const BondDamage> damage, const Nodes& nodes, double span) {
    std::vector<double> distances(graph.nodeCount(), 1e300);
    const auto isGiven = [&](std::uint32_t node) { return std::ranges::binary_search(nodes, node); };
    for (bool hasChanged = true; hasChanged;) {
        hasChanged = false;
        const auto lower = [&](std::uint32_t node, double to) {
            if (!isGiven(node) || !(to < distances[node])) return;
            distances[node] = to;
            hasChanged = true;
        };
        for (std::size_t k = 0; k < graph.bonds.size(); ++k) {
            const Bond& bond = graph.bonds[k];
            if (damage[k] == kBroken) continue;
            if (bond.second == kNone) {
                lower(bond.first, 0.0);
                continue;
            }
            const Vec3 apart = graph.centres[bond.second] - graph.centres[bond.first];
            const double sideways = glm::length(apart - glm::dot(apart, kUp) * kUp);
            const double corbel = 0.57735026918962576;  // tangent of 30 degrees
            const double upwards = std::max(0.0, sideways - corbel * apart.y);
            const double downwards = std::max(0.0, sideways + corbel * apart.y);
            if (distances[bond.first] < 1e300)
                lower(bond.second, distances[bond.first] + (bond.normal.y >= 0.5 ? upwards : sideways));
            if (distances[bond.second] < 1e300)
                lower(bond.first, distances[bond.second] + (bond.normal.y <= -0.5 ? downwards : sideways));
        }
    }
    Nodes list;
    for (const std::uint32_t node : nodes) {
        if (!(distances[node] <= (span > 0.0 ? span : 1e299))) list.push_back(node);
    }
    return list;
}

}  // namespace

class SupportTest : public QObject {
    Q_OBJECT
private slots:
    void aColumnStandsHoweverHigh() { QCOMPARE(unsupported(test::wallOfCubes(1, 30), 0.01), Nodes{}); }
    void aLeaningColumnStandsOnItsFoot() {
        std::vector<Vec3> centres;
        for (int k = 0; k < 10; ++k) centres.emplace_back(0.5 * k, k, 0.0);  // 27 degrees from upright
        std::vector<Bond> bonds{test::anchorBelow(centres, 0)};
        for (std::uint32_t k = 1; k < 10; ++k) bonds.push_back(test::bondBetween(centres, k - 1, k));
        QCOMPARE(unsupported(bondGraph(centres, bonds), 0.01), Nodes{});
        for (Vec3& centre : centres) centre.x *= 2.0;  // 45 degrees: a step is 1 m less 0.577 m
        QCOMPARE(unsupported(bondGraph(centres, bonds), 1.1), (Nodes{3, 4, 5, 6, 7, 8, 9}));
        for (Vec3& centre : centres) centre.x *= 0.5;
        for (std::size_t k = 1; k < bonds.size(); ++k) bonds[k].normal = {1.0, 0.0, 0.0};  // beside each other
        QCOMPARE(unsupported(bondGraph(centres, bonds), 1.1), (Nodes{3, 4, 5, 6, 7, 8, 9}));
    }
    // Piers at both ends of a row of 7: the middle is 3 m from them.
    void aLintelStandsUpToItsSpan() {
        const BondGraph wall = test::wallOfCubes(7, 2);
        Nodes open = bondsBelow(wall, {1, 2, 3, 4, 5, 8, 9, 10, 11, 12}, 7);
        for (std::uint32_t node = 0; node < 6; ++node) open.push_back(test::bondAt(wall, node, node + 1));
        const Nodes fallen{1, 2, 3, 4, 5};  // between the piers, nothing holds the lower row
        QCOMPARE(unsupported(wall, 3.1, open), fallen);
        QCOMPARE(unsupported(wall, 2.9, open), (Nodes{1, 2, 3, 4, 5, 10}));
        QCOMPARE(unsupported(wall, 1.1, open), (Nodes{1, 2, 3, 4, 5, 9, 10, 11}));
        QCOMPARE(unsupported(wall, 0.0, open), fallen);  // any distance
    }
    void aTowerOnOneCornerFallsBeyondItsSpan() {
        const BondGraph tower = test::wallOfCubes(4, 4);
        const Nodes feet = bondsBelow(tower, {1, 2, 3}, 4);
        QCOMPARE(unsupported(tower, 3.1, feet), Nodes{});
        QCOMPARE(unsupported(tower, 2.1, feet), (Nodes{3, 7, 11, 15}));
        QCOMPARE(unsupported(tower, 0.0, bondsBelow(tower, {0, 1, 2, 3}, 4)), test::allNodes(tower));
    }
    // A fragment that hangs right below another is as far sideways as that.
    void hangingFragmentsAreHeld() {
        const BondGraph wall = test::wallOfCubes(3, 2);
        Nodes open = bondsBelow(wall, {1, 2, 5}, 3);
        open.push_back(test::bondAt(wall, 0, 1)), open.push_back(test::bondAt(wall, 1, 2));
        QCOMPARE(unsupported(wall, 1.5, open), (Nodes{2, 5}));
    }
    void pathsStayAmongTheGivenNodes() {
        const BondGraph wall = test::wallOfCubes(1, 3);
        const std::vector<BondDamage> intact(wall.bondCount(), kIntact);
        QCOMPARE(unsupportedNodes(wall, intact, Nodes{0, 2}, limitsOf(wall, 1.0), kUp), Nodes{2});
    }
    void supportIsThatOfRelaxation() {
        for (std::uint64_t seed = 0; seed < 3000; ++seed) {
            Random random(seed);
            const BondGraph graph = test::randomBondGraph(random);
            const std::vector<BondDamage> damage = test::randomDamage(random, graph.bonds.size());
            const Nodes nodes = test::randomNodes(random, graph);
            const double span = seed % 5 == 0 ? 0.0 : random.between(0.0, 15.0);
            QVERIFY2(unsupportedNodes(graph, damage, nodes, limitsOf(graph, span), kUp) ==
                         relaxedUnsupported(graph, damage, nodes, span),
                     qPrintable(faultOfSeed(seed, "support differs from that of relaxation")));
        }
    }
    // Two arches of cubes on three piers, 5 m apart; their middles are 2 m from the nearest pier.
    void onlyWhatLosesSupportFalls() {
        const BondGraph wall = test::wallOfCubes(11, 2);
        Nodes open;
        for (const std::uint32_t node : {1u, 2u, 3u, 4u, 6u, 7u, 8u, 9u})
            open.push_back(test::bondAt(wall, node, kNone)), open.push_back(test::bondAt(wall, node, node + 11));
        for (std::uint32_t node = 0; node < 10; ++node) open.push_back(test::bondAt(wall, node, node + 1));
        QCOMPARE(unsupported(wall, 1.5, open), (Nodes{1, 2, 3, 4, 6, 7, 8, 9, 13, 14, 18, 19}));
        QCOMPARE(losingSupport(wall, 1.5, open, {}), Nodes{});
        // A bond between what is beyond the span, and one of a pier: what had a shorter way over them falls.
        QCOMPARE(losingSupport(wall, 1.5, open, {test::bondAt(wall, 13, 14)}), Nodes{});
        QCOMPARE(losingSupport(wall, 1.5, open, {test::bondAt(wall, 12, 13)}), Nodes{13});
        QCOMPARE(losingSupport(wall, 1.5, open, {test::bondAt(wall, 0, kNone)}), (Nodes{0, 11, 12, 13}));
        QCOMPARE(losingSupport(wall, 0.0, open, {test::bondAt(wall, 0, kNone), test::bondAt(wall, 0, 11)}), Nodes{0});
    }
    void nothingIsUnsupportedAtTheStart() {
        for (std::uint64_t seed = 0; seed < 1000; ++seed) {
            Random random(seed);
            const BondGraph graph = test::randomBondGraph(random);
            std::vector<BondDamage> damage = test::randomDamage(random, graph.bonds.size());
            const double span = seed % 5 == 0 ? 0.0 : random.between(0.0, 5.0);
            const std::vector<double> before = anchorDistances(graph, damage, kUp);
            const std::vector<double> limits = supportLimits(graph, damage, span, kUp);
            QCOMPARE(unsupportedNodes(graph, damage, test::allNodes(graph), limits, kUp), Nodes{});
            for (BondDamage& one : damage) one = random.below(5) == 0 ? kBroken : one;
            const std::vector<double> after = anchorDistances(graph, damage, kUp);
            const Nodes fallen = unsupportedNodes(graph, damage, test::allNodes(graph), limits, kUp);
            for (std::uint32_t node = 0; node < graph.nodeCount(); ++node) {
                const bool hasFallen = std::ranges::binary_search(fallen, node);
                const QByteArray fault = faultOfSeed(seed, "node " + std::to_string(node)).toUtf8();
                QVERIFY2(!hasFallen || before[node] < 1e300, fault);
                QVERIFY2(hasFallen || after[node] <= limits[node], fault);
            }
        }
    }
};

RUBBLE_TEST(SupportTest)
#include "SupportTest.moc"
