// Tests core/physics/step/Solver.cpp and core/physics/world/WorldMomenta.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SceneParts.h"
#include "tests/support/scenes/Scenes.h"

#include <QTest>

using namespace rubble;

namespace {

/// A plank of 2 x 0.2 x 0.05 m without gravity.
BodyScene flyingPlank(Vec3 velocity, Vec3 angularVelocity) {
    BodyScene scene;
    scene.gravity = Vec3(0.0);
    const std::uint32_t plank = test::addShape(scene, {test::boxOf({2.0, 0.2, 0.05})});
    scene.bodies.push_back({.name = "plank", .velocity = velocity, .angularVelocity = angularVelocity, .shape = plank});
    return scene;
}

double relativeChange(Vec3 before, Vec3 after) { return glm::distance(before, after) / glm::length(before); }

/// A stack of 1 m boxes on the ground, with gaps; negative gaps are overlaps.
BodyScene boxStack(int count, double gap, double restitution = 0.0) {
    BodyScene scene;
    test::addGround(scene, 10.0);
    const std::uint32_t box = test::addShape(scene, {test::boxOf({1.0, 1.0, 1.0})});
    for (int k = 0; k < count; ++k) {
        test::addFreeBody(scene, std::to_string(k), box, {.position = {0.0, 0.5 + gap + k * (1.0 + gap), 0.0}});
    }
    for (SceneBody& body : scene.bodies) body.restitution = restitution;
    return scene;
}

BodyScene heapOf(std::uint32_t count, double restitution) {
    BodyScene scene = test::heapScene(count);
    for (SceneBody& body : scene.bodies) body.restitution = restitution;
    return scene;
}

}  // namespace

/// Conservation of momentum and energy.
class EnergyTest : public QObject {
    Q_OBJECT
private slots:
    void freeFlightConservesMomentaAndEnergy_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<double>("z");
        QTest::newRow("about its length") << 8.0 << 0.01 << 0.0;
        QTest::newRow("about its middle axis, on which it tumbles") << 0.01 << 8.0 << 0.01;
        QTest::newRow("about its short axis") << 0.0 << 0.01 << 8.0;
        QTest::newRow("askew") << 3.0 << -4.0 << 5.0;
        QTest::newRow("slowly") << 0.2 << 0.3 << -0.1;
    }
    void freeFlightConservesMomentaAndEnergy() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(double, z);
        SceneWorld moved = test::worldOf(flyingPlank({0.5, -0.3, 0.2}, {x, y, z}));
        const Momenta before = moved.world.momenta();
        double most = before.kinetic;
        for (int step = 0; step < 3600; ++step) {
            moved.world.step(test::kStep);
            most = std::max(most, moved.world.momenta().kinetic);
        }
        const Momenta after = moved.world.momenta();
        qInfo("linear %.1e, angular %.1e, energy %+.1e, at most %+.1e", relativeChange(before.linear, after.linear),
              relativeChange(before.angular, after.angular), after.kinetic / before.kinetic - 1.0,
              most / before.kinetic - 1.0);
        QVERIFY(relativeChange(before.linear, after.linear) < 1e-4);
        QVERIFY(relativeChange(before.angular, after.angular) < 1e-4);
        QVERIFY(most <= 1.001 * before.kinetic);
    }
    void scenesDoNotGainEnergy_data() {
        QTest::addColumn<BodyScene>("scene");
        for (const double restitution : {0.0, 0.8}) {
            const std::string with = " with restitution " + std::to_string(restitution).substr(0, 3);
            QTest::newRow(("heap of 200" + with).c_str()) << heapOf(200, restitution);
            QTest::newRow(("stack of 10, standing" + with).c_str()) << boxStack(10, 0.0, restitution);
            QTest::newRow(("stack of 5, falling" + with).c_str()) << boxStack(5, 0.3, restitution);
        }
    }
    void scenesDoNotGainEnergy() {
        QFETCH(BodyScene, scene);
        SceneWorld moved = test::worldOf(scene, {.sleeping = false});
        const double before = test::energyOf(moved.world);
        double most = before;
        for (int step = 0; step < 600; ++step) {
            moved.world.step(test::kStep);
            most = std::max(most, test::energyOf(moved.world));
        }
        qInfo("before %.1f J, at most %+.4f %%, at the end %+.4f %%", before, 100.0 * (most / before - 1.0),
              100.0 * (test::energyOf(moved.world) / before - 1.0));
        QVERIFY(most <= 1.001 * before);
    }
    /// The work is that of lifting the boxes until none overlap.
    void resolvingOverlapsAddsAtMostItsWork_data() {
        QTest::addColumn<double>("overlap");
        QTest::newRow("2 mm") << 0.002;
        QTest::newRow("10 mm") << 0.01;
        QTest::newRow("50 mm") << 0.05;
    }
    void resolvingOverlapsAddsAtMostItsWork() {
        QFETCH(double, overlap);
        SceneWorld moved = test::worldOf(boxStack(5, -overlap), {.sleeping = false});
        const double apart = test::energyOf(test::worldOf(boxStack(5, 0.0)).world);
        double most = 0.0;
        for (int step = 0; step < 600; ++step) {
            moved.world.step(test::kStep);
            most = std::max(most, test::energyOf(moved.world));
        }
        qInfo("at most %+.3f %%, at the end %+.3f %%", 100.0 * (most / apart - 1.0),
              100.0 * (test::energyOf(moved.world) / apart - 1.0));
        QVERIFY(test::energyOf(moved.world) <= 1.001 * apart);
        QVERIFY(moved.world.momenta().kinetic < 1e-3);
    }
    /// The push-out velocity of 3 m/s is removed after each sub-step, up to a tenth.
    void overlapsWithoutGravitySeparateSlowly() {
        BodyScene scene;
        scene.gravity = Vec3(0.0);
        const std::uint32_t box = test::addShape(scene, {test::boxOf({1.0, 1.0, 1.0})});
        test::addFreeBody(scene, "left", box, {.position = {0.0, 0.0, 0.0}});
        test::addFreeBody(scene, "right", box, {.position = {0.9, 0.0, 0.0}});
        SceneWorld moved = test::worldOf(scene);
        test::simulate(moved.world, 5.0);
        const Vec3 speed = moved.world.state(moved.bodies[1]).velocity;
        qInfo("%.4f m/s", glm::length(speed));
        QVERIFY(penetrationOf(scene, test::posesOf(moved)).largest < 1e-3);
        QVERIFY(glm::length(speed) < 0.3);
    }
};

RUBBLE_TEST(EnergyTest)
#include "EnergyTest.moc"
