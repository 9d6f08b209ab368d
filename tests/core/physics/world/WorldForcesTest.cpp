#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SceneParts.h"

#include <cmath>

using namespace rubble;

namespace {

/// A free cube of 1 m and 1000 kg at a distance along x from the origin.
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
    void valuesOutOfRangeAreRefused() {
        SceneWorld made = cubeAt(2.0);
        World& world = made.world;
        const BodyId cube = made.bodies[0];
        const ContentHash before = world.hash();
        for (const double wrong : {std::nan(""), static_cast<double>(INFINITY), 1e39, -1e300}) {
            const Vec3 vector(0.0, wrong, 0.0);
            QCOMPARE(world.setGravity(vector).error().code, ErrorCode::BadInput);
            QCOMPARE(world.setVelocity(cube, vector, Vec3(0.0)).error().code, ErrorCode::BadInput);
            QCOMPARE(world.setVelocity(cube, Vec3(0.0), vector).error().code, ErrorCode::BadInput);
            QCOMPARE(world.setPose(cube, {vector, Quat{1.0, 0.0, 0.0, 0.0}}).error().code, ErrorCode::BadInput);
            QCOMPARE(world.applyImpulse(cube, vector, Vec3(0.0)).error().code, ErrorCode::BadInput);
            QCOMPARE(world.applyImpulse(cube, Vec3(1.0), vector).error().code, ErrorCode::BadInput);
            QCOMPARE(world.explode(vector, 1.0, 1.0).error().code, ErrorCode::BadInput);
            QCOMPARE(world.explode(Vec3(0.0), wrong, 1.0).error().code, ErrorCode::BadInput);
            QCOMPARE(world.explode(Vec3(0.0), 1.0, wrong).error().code, ErrorCode::BadInput);
            QCOMPARE(world.grab(cube, vector, 1.0).error().code, ErrorCode::BadInput);
            QCOMPARE(world.grab(cube, Vec3(0.0), wrong).error().code, ErrorCode::BadInput);
            QCOMPARE(world.dragTo(vector).error().code, ErrorCode::BadInput);
            QCOMPARE(world.setMaterial(cube, {.density = wrong}).error().code, ErrorCode::BadInput);
        }
        QCOMPARE(world.applyImpulse(cube, Vec3(1e25), Vec3(0.0)).error().message,
                 std::string("An impulse must be finite and at most 1e+24 N·s along each axis."));
        QCOMPARE(world.explode(Vec3(0.0), 1.0, 1e25).error().message,
                 std::string("The impulse of a blast must be finite and at most 1e+24 N·s/m²."));
        QVERIFY(world.hash() == before);
    }
    void strongImpulsesAccelerateToTheLargestSpeed() {
        SceneWorld made = cubeAt(2.0);
        QVERIFY(made.world.applyImpulse(made.bodies[0], {0.0, 0.0, 1e24}, {2.5, 0.0, 0.0}));
        const BodyState state = made.world.state(made.bodies[0]);
        QVERIFY(glm::distance(state.velocity, Vec3(0.0, 0.0, kMaxSpeed)) < 1e-2);
        QVERIFY(std::abs(glm::length(state.angularVelocity) - kMaxSpeed) < 1e-2);
        QVERIFY(made.world.isWithinBounds(made.bodies[0]));
        for (int step = 0; step < 11 * 60; ++step) made.world.step(1.0 / 60.0);
        QVERIFY(!made.world.isWithinBounds(made.bodies[0]));  // 100 km
    }
    void massesBeyondSinglePrecisionAreRefused() {
        SceneWorld made = cubeAt(2.0);
        const Polytope speck = test::boxOf(Vec3(1e-10));
        const Result<std::shared_ptr<const Shape>> shape = makeShape({&speck, 1});
        QVERIFY(shape);
        const Result<BodyId> added = made.world.addBody({.shape = *shape});
        QVERIFY(!added);
        QVERIFY2(added.error().message.find("single precision") != std::string::npos, added.error().message.c_str());
    }
};

RUBBLE_TEST(WorldForcesTest)
#include "WorldForcesTest.moc"
