#include "core/structure/bonds/MortarBonds.h"

#include "tests/support/Closeness.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/structure/PlacedBoxes.h"

#include <QTest>

#include <algorithm>
#include <set>

using namespace rubble;
using namespace rubble::test;

namespace {

constexpr double kTolerance = 0.005;  // m

MortarNode boxNode(std::uint32_t body, Vec3 min, Vec3 max) { return {body, (min + max) / 2.0, {boxBetween(min, max)}}; }

/// Boxes of about 1 m in a grid with joints of 0 to 8 mm, each a body of its own.
std::vector<MortarNode> gridOfBoxes(Random& random, int columns, int rows) {
    std::vector<MortarNode> nodes;
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const Vec3 min{column, row, 0.0}, joint{random.between(0.0, 0.004), random.between(0.0, 0.004), 0.0};
            nodes.push_back(boxNode(static_cast<std::uint32_t>(nodes.size()), min + joint, min + Vec3(1.0) - joint));
        }
    }
    return nodes;
}

}  // namespace

class MortarBondsTest : public QObject {
    Q_OBJECT
private slots:
    void boxesOfDifferentBodiesAreJoined() {
        const std::vector<MortarNode> nodes{boxNode(0, {0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}),
                                            boxNode(0, {1.0, 0.0, 0.0}, {2.0, 1.0, 1.0}),
                                            boxNode(1, {0.5, 1.004, 0.0}, {2.5, 2.0, 1.0})};
        const std::vector<Bond> bonds = mortarBonds(nodes, kTolerance, 0.01);
        QCOMPARE(bonds.size(), std::size_t{2});
        QVERIFY(!verifyBonds(bonds, 3));
        QCOMPARE(bonds[0].first, 0u);
        QCOMPARE(bonds[0].second, 2u);
        QVERIFY(isNear(bonds[0].area, 0.5));
        QVERIFY(isWithinDistance(bonds[0].centroid, {0.75, 1.002, 0.5}, 1e-12));
        QVERIFY(isWithinDistance(bonds[0].normal, {0.0, 1.0, 0.0}, 1e-12));
        QVERIFY(isNear(bonds[0].seedDistance, 1.002));  // centres at 0.5 and 1.502 m
        QVERIFY(isNear(bonds[1].area, 1.0));
        QCOMPARE(mortarBonds(nodes, kTolerance, 0.6).size(), std::size_t{1});
        QVERIFY(mortarBonds(nodes, 0.003, 0.01).empty());
        QVERIFY(mortarBonds({}, kTolerance, 0.01).empty());
    }
    void hullsOfOneFragmentAreOneBond() {
        MortarNode halves = boxNode(0, {0.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
        halves.hulls = {boxBetween({0.0, 0.0, 0.0}, {0.25, 1.0, 1.0}), boxBetween({0.25, 0.0, 0.0}, {1.0, 1.0, 1.0})};
        const std::vector<MortarNode> nodes{halves, boxNode(1, {0.0, 1.0, 0.0}, {1.0, 2.0, 1.0})};
        const std::vector<Bond> bonds = mortarBonds(nodes, kTolerance, 0.9);
        QCOMPARE(bonds.size(), std::size_t{1});
        QVERIFY(isNear(bonds[0].area, 1.0));
        QVERIFY(isWithinDistance(bonds[0].centroid, {0.5, 1.0, 0.5}, 1e-12));
        QVERIFY(isNear(bonds[0].moments[0].x, 1.0 / 12.0));
    }
    void anchorsAreWhereSupportsTouch() {
        const std::vector<MortarNode> nodes{boxNode(0, {0.0, 1.0, 0.0}, {1.0, 2.0, 1.0}),
                                            boxNode(0, {0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}),
                                            boxNode(3, {1.0, 0.0, 0.0}, {2.0, 1.0, 1.0})};
        // The floor is two slabs, which meet under the first box.
        const std::vector<Polytope> floor{boxBetween({-5.0, -1.0, -5.0}, {0.5, 0.0, 5.0}),
                                          boxBetween({0.5, -1.0, -5.0}, {5.0, -0.001, 5.0})};
        const std::vector<Bond> bonds = anchorBonds(nodes, floor, kTolerance, 0.01);
        QCOMPARE(bonds.size(), std::size_t{2});
        QVERIFY(!verifyBonds(bonds, 3));
        QCOMPARE(bonds[0].first, 1u);
        QCOMPARE(bonds[0].second, kNone);
        QVERIFY(isNear(bonds[0].area, 1.0));
        QVERIFY(isWithinDistance(bonds[0].normal, {0.0, -1.0, 0.0}, 1e-12));
        QVERIFY(isNear(bonds[0].seedDistance, 0.5 + 0.00025));  // half of it at half of the joint
        QCOMPARE(bonds[1].first, 2u);
    }
    /// Wherever rounding puts them, as long as they are apart by it alone.
    void touchingFacesAreJoinedWithoutATolerance() {
        Random random(7);
        for (int round = 0; round < 1000; ++round) {
            const double far = round % 2 == 0 ? 10.0 : 1e5;
            const Vec3 at{random.between(-far, far), random.between(-far, far), random.between(-far, far)};
            const Vec3 size{random.between(0.1, 3.0), random.between(0.1, 3.0), random.between(0.1, 3.0)};
            const Vec3 next = at + Vec3(size.x, 0.0, 0.0);
            const std::vector<MortarNode> nodes{boxNode(0, at, at + size), boxNode(1, next, next + size)};
            QCOMPARE(mortarBonds(nodes, 0.0, 0.0).size(), std::size_t{1});
            const std::vector<Polytope> support{boxBetween(next, next + size)};
            QCOMPARE(anchorBonds({nodes.data(), 1}, support, 0.0, 0.0).size(), std::size_t{1});
            const Vec3 apart = next + Vec3(1e-5, 0.0, 0.0);
            QVERIFY(mortarBonds(std::vector{nodes[0], boxNode(1, apart, apart + size)}, 0.0, 0.0).empty());
        }
    }
    void allPairsWithinToleranceAreJoined() {
        for (std::uint64_t seed = 0; seed < 100; ++seed) {
            Random random(seed);
            std::vector<MortarNode> nodes = gridOfBoxes(random, 5, 4);
            for (std::size_t k = nodes.size(); k > 1; --k) std::swap(nodes[k - 1], nodes[random.below(k)]);
            const std::vector<Bond> bonds = mortarBonds(nodes, kTolerance, 1e-3);
            QVERIFY2(!verifyBonds(bonds, 20), qPrintable(faultOfSeed(seed, "the bonds are not valid")));
            std::size_t next = 0;
            for (std::uint32_t i = 0; i < nodes.size(); ++i) {
                for (std::uint32_t j = i + 1; j < nodes.size(); ++j) {
                    const auto contact = faceContact(nodes[i].hulls[0], nodes[j].hulls[0], kTolerance, 1e-3);
                    if (!contact) continue;
                    const bool isThere = next < bonds.size() && bonds[next].first == i && bonds[next].second == j &&
                                         bonds[next].area == contact->area;
                    QVERIFY2(isThere, qPrintable(faultOfSeed(seed, "a pair is not joined")));
                    ++next;
                }
            }
            QVERIFY2(next == bonds.size() && next > 0, qPrintable(faultOfSeed(seed, "a bond has no contact")));
        }
    }
    void gridsOfAnySizeAreJoinedAtAllJoints() {
        for (const int side : {5, 10, 20}) {
            Random random(7);
            const std::size_t joints = 2u * side * (side - 1u);
            QCOMPARE(mortarBonds(gridOfBoxes(random, side, side), 0.01, 1e-3).size(), joints);
        }
    }
};

RUBBLE_TEST(MortarBondsTest)
#include "MortarBondsTest.moc"
