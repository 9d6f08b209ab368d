#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SceneParts.h"

using namespace rubble;

namespace {

constexpr double kImpulse = 1000.0;  // N·s per m² at 1 m
constexpr double kRadius = 6.0;      // m

/// A free cube of 1 m and 1000 kg at a distance along x from a blast in the origin. Its mean projected area is 6/4 m².
SceneWorld cubeAt(double distance) {
    BodyScene scene;
    scene.gravity = Vec3(0.0);
    test::addFreeBody(scene, "cube", test::addShape(scene, {test::boxOf(Vec3(1.0))}),
                      {.position = {distance, 0.0, 0.0}});
    return test::worldOf(scene);
}

}  // namespace

class WorldForcesTest : public QObject {
    Q_OBJECT
private slots:
    void blastFallsOffWithTheSquareOfTheDistance_data() {
        QTest::addColumn<double>("distance");
        QTest::addColumn<double>("expected");
        QTest::newRow("1 m") << 1.0 << 1500.0;
        QTest::newRow("2 m") << 2.0 << 375.0;
        QTest::newRow("4 m") << 4.0 << 93.75;
        QTest::newRow("at the radius") << 6.0 << 1500.0 / 36.0;
        QTest::newRow("clamped to 0.1 m") << 0.05 << 150000.0;
    }
    void blastFallsOffWithTheSquareOfTheDistance() {
        QFETCH(double, distance);
        QFETCH(double, expected);
        SceneWorld made = cubeAt(distance);
        const std::vector<BlastImpulse> impulses = made.world.blast(Vec3(0.0), kRadius, kImpulse);
        QCOMPARE(impulses.size(), 1u);
        QVERIFY(glm::distance(impulses[0].impulse, Vec3(expected, 0.0, 0.0)) < 1e-5 * expected);  // single precision
        made.world.explode(Vec3(0.0), kRadius, kImpulse);
        const Vec3 velocity = made.world.state(made.bodies[0]).velocity;
        QVERIFY(glm::distance(velocity, Vec3(expected / 1000.0, 0.0, 0.0)) < 1e-5 * expected / 1000.0);
    }
    void blastIgnoresBodiesBeyondItsRadius() {
        SceneWorld made = cubeAt(kRadius + 0.01);
        QVERIFY(made.world.blast(Vec3(0.0), kRadius, kImpulse).empty());
    }
};

RUBBLE_TEST(WorldForcesTest)
#include "WorldForcesTest.moc"
