#include "core/physics/step/BroadPhase.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SceneParts.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

bool isNear(Vec3f a, Vec3f b) { return length(a - b) < 1e-5f; }

/// Cubes of 1 m at these places, without gravity.
SceneWorld cubesAt(const std::vector<Vec3>& places) {
    BodyScene scene;
    scene.gravity = Vec3(0.0);
    const std::uint32_t shape = addShape(scene, {boxOf(Vec3(1.0))});
    for (std::size_t k = 0; k < places.size(); ++k) {
        addFreeBody(scene, std::to_string(k), shape, {.position = places[k]});
    }
    return worldOf(scene);
}

}  // namespace

class BroadPhaseTest : public QObject {
    Q_OBJECT
private slots:
    /// Sides of 2, 4 and 6 m, rotated by 90 degrees about z: x and y change places.
    void tightBoxOfARotatedHull() {
        BodyPose pose;
        pose.centre = Vec3f(10.0f, 20.0f, 30.0f);
        pose.rotation = {0.0f, 0.0f, std::sqrt(0.5f), std::sqrt(0.5f)};
        const Hull hull = hullOf(boxOf({2.0, 4.0, 6.0}));
        const Box box = tightBox({&hull}, pose);
        QVERIFY(isNear(box.low, Vec3f(8.0f, 19.0f, 27.0f)));
        QVERIFY(isNear(box.high, Vec3f(12.0f, 21.0f, 33.0f)));
        const Box beside = tightBox({&hull, Vec3f(1.0f, 0.0f, 0.0f)}, pose);
        QVERIFY(isNear(beside.low, Vec3f(8.0f, 20.0f, 27.0f)));
    }
    void pairsAreThoseOfFatBoxes() {
        // The margin of each of two cubes is at least 20 mm, and less than a metre.
        SceneWorld near = cubesAt({{0.0, 0.0, 0.0}, {1.03, 0.0, 0.0}}),
                   far = cubesAt({{0.0, 0.0, 0.0}, {3.0, 0.0, 0.0}});
        near.world.collide(kStep);
        far.world.collide(kStep);
        QCOMPARE(near.world.counts().candidatePairs, 1);
        QCOMPARE(far.world.counts().candidatePairs, 0);
    }
    /// At 120 m/s it moves 2 m in the step.
    void fastBodiesFindWhatTheyMayReach() {
        SceneWorld made = cubesAt({{0.0, 0.0, 0.0}, {2.5, 0.0, 0.0}, {-2.5, 0.0, 0.0}});
        QVERIFY(made.world.setVelocity(made.bodies[0], {120.0, 0.0, 0.0}, Vec3(0.0)));
        made.world.collide(kStep);
        QCOMPARE(made.world.counts().candidatePairs, 1);
    }
    /// Its box leads 0.5 m ahead of it for what flies, too, but 5 m for what stands.
    void whatFliesMeetsWhatMovesIntoItsWayWithinTheStep() {
        SceneWorld made = cubesAt({{0.0, 0.0, 0.0}, {0.0, 50.0, 0.0}});
        QVERIFY(made.world.setVelocity(made.bodies[0], {300.0, 0.0, 0.0}, Vec3(0.0)));
        made.world.collide(kStep);
        QCOMPARE(made.world.counts().candidatePairs, 0);
        QVERIFY(made.world.setPose(made.bodies[1], {.position = {3.5, 0.0, 0.0}}));
        made.world.collide(kStep);
        QCOMPARE(made.world.counts().candidatePairs, 1);
        QVERIFY(made.world.setPose(made.bodies[1], {.position = {3.6, 0.0, 0.0}}));
        made.world.collide(kStep);  // no longer found by a move, the pair stays
        QCOMPARE(made.world.counts().candidatePairs, 1);
    }
    /// One behind the other at 60 m/s, 0.7 m apart: each moves 1 m in the step, through where the other was.
    void whatFliesTogetherMakesNoPairs() {
        SceneWorld made = cubesAt({{0.0, 0.0, 0.0}, {1.7, 0.0, 0.0}});
        for (const BodyId body : made.bodies) QVERIFY(made.world.setVelocity(body, {60.0, 0.0, 0.0}, Vec3(0.0)));
        made.world.collide(kStep);
        QCOMPARE(made.world.counts().candidatePairs, 0);
    }
    void pairsEndWhereBoxesPart() {
        SceneWorld made = cubesAt({{0.0, 0.0, 0.0}, {1.03, 0.0, 0.0}});
        QVERIFY(made.world.setVelocity(made.bodies[1], {10.0, 0.0, 0.0}, Vec3(0.0)));
        made.world.step(kStep);
        QCOMPARE(made.world.counts().candidatePairs, 1);
        simulate(made.world, 0.5);
        QCOMPARE(made.world.counts().candidatePairs, 0);
    }
    void movedBodiesFindTheirNeighbours() {
        SceneWorld made = cubesAt({{0.0, 0.0, 0.0}, {10.0, 0.0, 0.0}});
        made.world.step(kStep);
        QVERIFY(made.world.setPose(made.bodies[1], {.position = {0.0, 1.01, 0.0}}));
        made.world.step(kStep);
        QCOMPARE(made.world.counts().candidatePairs, 1);
    }
    void fixedBodiesMakeNoPairs() {
        BodyScene scene;
        addFixedBox(scene, "a", {0.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
        addFixedBox(scene, "b", {0.5, 0.0, 0.0}, {1.5, 1.0, 1.0});
        SceneWorld made = worldOf(scene);
        made.world.collide(kStep);
        QCOMPARE(made.world.counts().candidatePairs, 0);
    }
    void removedBodiesLeaveNoPairs() {
        SceneWorld made = cubesAt({{0.0, 0.0, 0.0}, {1.01, 0.0, 0.0}, {2.02, 0.0, 0.0}});
        made.world.collide(kStep);
        QCOMPARE(made.world.counts().candidatePairs, 2);
        made.world.removeBody(made.bodies[1]);
        QCOMPARE(made.world.counts().candidatePairs, 0);
    }
};

RUBBLE_TEST(BroadPhaseTest)
#include "BroadPhaseTest.moc"
