// Tests core/physics/step/RollingResistance.cpp.
#include "core/physics/step/RollingResistance.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SceneParts.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

/// A part of a wheel of 64 sides about z, of a radius of 0.3 m: all of it, or its lower half.
Polytope wheel(bool isWhole) {
    std::vector<Vec2> ring;
    for (int k = isWhole ? 0 : 32; k <= (isWhole ? 63 : 64); ++k) {
        const double angle = 2.0 * std::numbers::pi * k / 64.0;
        ring.push_back({0.3 * cosine(angle), 0.3 * sine(angle)});
    }
    return extruded(ring, -0.1, 0.1);
}

/// The state of a body on a floor after some time, s.
BodyState after(const Polytope& hull, const BodyState& start, double time) {
    BodyScene scene;
    const std::uint32_t floor = addShape(scene, {boxOf({20.0, 1.0, 20.0})}), shape = addShape(scene, {hull});
    scene.bodies.push_back(
        {.name = "floor", .kind = BodyKind::Static, .pose = {.position = {0.0, -0.5, 0.0}}, .shape = floor});
    scene.bodies.push_back({.name = "body",
                            .pose = start.pose,
                            .velocity = start.velocity,
                            .angularVelocity = start.angularVelocity,
                            .shape = shape});
    SceneWorld world = worldOf(scene);
    for (int k = 0; k < static_cast<int>(time / kStep); ++k) world.world.step(kStep);
    return world.world.state(world.bodies[1]);
}

BodyState rolling(double speed) {
    return {.pose = {.position = {0.0, 0.2997, 0.0}},
            .velocity = {speed, 0.0, 0.0},
            .angularVelocity = {0.0, 0.0, -speed / 0.3}};
}

}  // namespace

class RollingResistanceTest : public QObject {
    Q_OBJECT
private slots:
    void facesAtSmallAnglesAreRound() {
        QVERIFY(isRounded(**makeShape(std::vector{wheel(true)})));
        QVERIFY(!isRounded(*boxShape({1.0, 1.0, 1.0})));
    }
    /// A disc of mass m rolls with 3/2 of its inertia: resistance takes 0.02 g / 1.5 of its speed per second. At a
    /// corner of n, which stops what leads into the ground, it keeps 1 - (1 - cos(2 pi / n)) / 1.5 of it.
    void aWheelSlowsDown() {
        const double resisted = 0.02 * 9.81 / 1.5;
        const double perMetre =
            (1.0 - std::cos(2.0 * std::numbers::pi / 64.0)) / 1.5 * 64.0 / (2.0 * std::numbers::pi * 0.3);
        double expected = 2.0;
        for (int k = 0; k < 1000; ++k) expected -= (resisted + perMetre * expected * expected) / 1000.0;
        const double speed = after(wheel(true), rolling(2.0), 1.0).velocity.x;
        QVERIFY2(std::abs(speed - expected) < 0.02, qPrintable(QString("%1, not %2").arg(speed).arg(expected)));
    }
    void aWheelComesToRest() { QVERIFY(after(wheel(true), rolling(0.3), 6.0).asleep); }
    /// Half a wheel that is tilted by 20 degrees rocks.
    void aRockerComesToRest() {
        BodyState tilted = rolling(0.0);
        tilted.pose = {.position = {0.0, 0.301, 0.0}, .orientation = {cosine(0.17), 0.0, 0.0, sine(0.17)}};
        QVERIFY(after(wheel(false), tilted, 8.0).asleep);
    }
};

RUBBLE_TEST(RollingResistanceTest)
#include "RollingResistanceTest.moc"
