// Tests core/physics/step/Solver.cpp.
#include "core/base/math/Trigonometry.h"
#include "core/geometry/hull/ConvexHull.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SceneParts.h"

#include <QTest>

using namespace rubble;

namespace {

/// A ball of rings of `sides` points. It lands on a face below its middle, which does not make it rotate.
Polytope ballOf(double radius, int rings, int sides) {
    std::vector<Vec3> corners;
    for (int ring = 0; ring < rings; ++ring) {
        const double polar = std::numbers::pi * (ring + 0.5) / rings;
        for (int side = 0; side < sides; ++side) {
            const double angle = 2.0 * std::numbers::pi * side / sides;
            corners.push_back(radius * Vec3(sine(polar) * cosine(angle), cosine(polar), sine(polar) * sine(angle)));
        }
    }
    return *convexHull(corners);
}

/// A ball of 0.5 m whose lowest point is `height` above the ground.
BodyScene ballOver(double height, double restitution) {
    BodyScene scene;
    test::addGround(scene, 20.0);
    const Polytope ball = ballOf(0.5, 12, 16);
    double lowest = 0.0;
    for (const Vec3& corner : ball.vertices) lowest = std::min(lowest, corner.y);
    const std::uint32_t shape = test::addShape(scene, {ball});
    test::addFreeBody(scene, "ball", shape, {.position = {0.0, height - lowest, 0.0}});
    scene.bodies[1].restitution = restitution;
    return scene;
}

/// The rebound height of the ball's centre above that at first contact.
double heightAfterBounce(const BodyScene& scene, double touchHeight) {
    SceneWorld moved = test::worldOf(scene, {.sleeping = false});
    double highest = 0.0;
    bool hasBounced = false;
    for (int step = 0; step < 180; ++step) {
        moved.world.step(test::kStep);
        const BodyState state = moved.world.state(moved.bodies[1]);
        const double height = state.pose.position.y - touchHeight;
        hasBounced = hasBounced || height < 0.02;
        if (hasBounced && state.velocity.y < 0.0 && highest > 0.0) break;
        if (hasBounced) highest = std::max(highest, height);
    }
    return highest;
}

/// A box resting on a slope.
BodyScene boxOnSlope(double degrees, double friction) {
    const double angle = degrees * std::numbers::pi / 180.0;
    const Quat turn{cosine(0.5 * angle), 0.0, 0.0, sine(0.5 * angle)};
    BodyScene scene;
    const std::uint32_t slope = test::addShape(scene, {test::boxOf({100.0, 2.0, 10.0})});
    const std::uint32_t box = test::addShape(scene, {test::boxOf({1.0, 0.5, 1.0})});
    scene.bodies.push_back({.name = "slope",
                            .kind = BodyKind::Static,
                            .friction = friction,
                            .pose = {.orientation = turn},
                            .shape = slope});
    scene.bodies.push_back({.name = "box",
                            .friction = friction,
                            .pose = {.position = turn * Vec3(0.0, 1.25, 0.0), .orientation = turn},
                            .shape = box});
    return scene;
}

}  // namespace

/// Textbook experiments of restitution and friction.
class MaterialsTest : public QObject {
    Q_OBJECT
private slots:
    void ballReboundsToTheSquareOfItsRestitution_data() {
        QTest::addColumn<double>("restitution");
        QTest::newRow("0.5") << 0.5;
        QTest::newRow("0.8") << 0.8;
    }
    void ballReboundsToTheSquareOfItsRestitution() {
        QFETCH(double, restitution);
        const BodyScene scene = ballOver(4.0, restitution);
        const double touch = scene.bodies[1].pose.position.y - 4.0;
        const double rise = heightAfterBounce(scene, touch) / 4.0;
        qInfo("%.3f", rise);
        QVERIFY(std::abs(rise - restitution * restitution) < 0.01);  // gravity acts for a step more or less
    }
    void boxLandingFlatDoesNotRotate() {
        BodyScene scene;
        test::addGround(scene, 20.0);
        test::addFreeBody(scene, "box", test::addShape(scene, {test::boxOf({1.0, 1.0, 1.0})}),
                          {.position = {0.0, 4.5, 0.0}});
        scene.bodies[1].restitution = 0.8;
        SceneWorld moved = test::worldOf(scene);
        test::simulate(moved.world, 1.2);
        const BodyState state = moved.world.state(moved.bodies[1]);
        QVERIFY(state.velocity.y > 4.0);
        QVERIFY(glm::length(state.angularVelocity) < 0.01);
    }
    /// A fall from 4 cm ends at 0.9 m/s.
    void noRestitutionBelowOneMetrePerSecond() {
        const BodyScene scene = ballOver(0.04, 0.8);
        const double touch = scene.bodies[1].pose.position.y - 0.04;
        SceneWorld moved = test::worldOf(scene, {.sleeping = false});
        test::simulate(moved.world, 0.2);
        double highest = 0.0;
        for (int step = 0; step < 30; ++step) {
            moved.world.step(test::kStep);
            highest = std::max(highest, moved.world.state(moved.bodies[1]).pose.position.y - touch);
        }
        qInfo("%.2f mm", 1e3 * highest);
        QVERIFY(highest < 2e-3);
    }
    /// tan 20 degrees is 0.36, less than the friction of 0.6.
    void boxRestsOnAGentleSlope() {
        const BodyScene scene = boxOnSlope(20.0, 0.6);
        SceneWorld moved = test::worldOf(scene, {.sleeping = false});
        test::simulate(moved.world, 5.0);
        qInfo("%.3f mm", 1e3 * test::farthestMoved(scene, moved));
        QVERIFY(test::farthestMoved(scene, moved) < 1e-3);
    }
    /// tan 40 degrees is 0.84: it slides at g (sin 40 - 0.6 cos 40).
    void boxSlidesDownASteepSlope() {
        const BodyScene scene = boxOnSlope(40.0, 0.6);
        SceneWorld moved = test::worldOf(scene, {.sleeping = false});
        test::simulate(moved.world, 0.5);
        const double before = glm::length(moved.world.state(moved.bodies[1]).velocity);
        test::simulate(moved.world, 2.0);
        const double acceleration = (glm::length(moved.world.state(moved.bodies[1]).velocity) - before) / 2.0;
        const double angle = 40.0 * std::numbers::pi / 180.0;
        const double expected = 9.81 * (sine(angle) - 0.6 * cosine(angle));
        qInfo("%.4f m/s², expected %.4f", acceleration, expected);
        QVERIFY(std::abs(acceleration - expected) < 0.02 * expected);
    }
    void frictionOfAPairIsTheGeometricMean() {
        BodyScene scene = boxOnSlope(40.0, 0.3);
        scene.bodies[1].friction = 1.2;  // the root of 0.36 is 0.6
        SceneWorld moved = test::worldOf(scene, {.sleeping = false});
        test::simulate(moved.world, 2.0);
        const double angle = 40.0 * std::numbers::pi / 180.0;
        const double expected = 2.0 * 9.81 * (sine(angle) - 0.6 * cosine(angle));
        QVERIFY(std::abs(glm::length(moved.world.state(moved.bodies[1]).velocity) - expected) < 0.03 * expected);
    }
};

RUBBLE_TEST(MaterialsTest)
#include "MaterialsTest.moc"
