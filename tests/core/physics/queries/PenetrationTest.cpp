#include "core/physics/queries/Penetration.h"

#include "tests/support/TestProgram.h"
#include "tests/support/scenes/SceneParts.h"

#include <QTest>

#include <array>

using namespace rubble;

namespace {

/// Boxes of 1 m at these positions along x.
BodyScene rowOfBoxes(std::initializer_list<double> places) {
    BodyScene scene;
    const std::uint32_t box = test::addShape(scene, {test::boxOf({1.0, 1.0, 1.0})});
    for (const double x : places) {
        test::addFreeBody(scene, std::to_string(x), box, {.position = {x, 0.0, 0.0}});
    }
    return scene;
}

Penetration penetrationAsPlaced(const BodyScene& scene) {
    std::vector<Pose> poses;
    for (const SceneBody& body : scene.bodies) poses.push_back(body.pose);
    return penetrationOf(scene, poses);
}

}  // namespace

class PenetrationTest : public QObject {
    Q_OBJECT
private slots:
    void overlapIsTheDeepestOfEachPair() {
        const Penetration found = penetrationAsPlaced(rowOfBoxes({0.0, 0.75, 5.0, 5.875, 8.0}));
        QCOMPARE(found.pairs, std::size_t{2});
        QCOMPARE(found.largest, 0.25);
        QCOMPARE(found.mean, 0.1875);
    }
    void touchingAndSeparatedBodiesDoNotOverlap() {
        const Penetration found = penetrationAsPlaced(rowOfBoxes({0.0, 1.0, 2.5}));
        QCOMPARE(found.pairs, std::size_t{0});
        QCOMPARE(found.largest, 0.0);
        QCOMPARE(found.mean, 0.0);
    }
    void overlapOfFixedBodiesIsIgnored() {
        BodyScene scene = rowOfBoxes({0.0, 0.5, 1.25});
        scene.bodies[0].kind = BodyKind::Static;
        scene.bodies[1].kind = BodyKind::Static;
        QCOMPARE(penetrationAsPlaced(scene).largest, 0.25);
    }
    void bodyOfSeveralHullsCountsOnceByItsDeepest() {
        BodyScene scene = rowOfBoxes({0.0, 0.75});
        scene.shapes[0].push_back(translated(test::boxOf({1.0, 1.0, 1.0}), {0.125, 0.0, 0.0}));
        const Penetration found = penetrationAsPlaced(scene);
        QCOMPARE(found.pairs, std::size_t{1});
        QCOMPARE(found.largest, 0.375);
    }
    void bodiesOfARowAreComparedWithTheirNeighboursOnly() {
        constexpr std::size_t kCount = 1000;
        const std::array<Polytope, 1> box{test::boxOf({1.0, 1.0, 1.0})};
        std::vector<PosedHulls> bodies;
        for (std::size_t k = 0; k < kCount; ++k)
            bodies.push_back({box, {.position = {0.75 * static_cast<double>(k), 0.0, 0.0}}});
        OverlapSearch search;
        QCOMPARE(overlapsOf(bodies, search).size(), kCount - 1);
        QCOMPARE(search.compared, kCount - 1);
        for (std::size_t k = 0; k < kCount; ++k)  // a column, all above each other
            bodies[k].pose.position = {0.0, 0.75 * static_cast<double>(k), 0.0};
        search = {};
        QCOMPARE(overlapsOf(bodies, search).size(), kCount - 1);
        QCOMPARE(search.compared, kCount - 1);
    }
    void searchEndsAtItsLimit() {
        const std::array<Polytope, 1> box{test::boxOf({1.0, 1.0, 1.0})};
        const std::vector<PosedHulls> bodies(300, {box, {}});  // in one place
        OverlapSearch search{.most = 500};
        QCOMPARE(overlapsOf(bodies, search).size(), std::size_t{501});
        QCOMPARE(search.compared, std::size_t{501});
        QVERIFY(!search.isComplete);
        search = {.least = 0.999};
        QCOMPARE(overlapsOf(bodies, search).size(), std::size_t{300 * 299 / 2});
        QVERIFY(search.isComplete);
        search = {.least = 1.001};
        QVERIFY(overlapsOf(bodies, search).empty());
    }
};

RUBBLE_TEST(PenetrationTest)
#include "PenetrationTest.moc"
