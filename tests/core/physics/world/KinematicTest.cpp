// Tests core/physics/islands/Sleeping.cpp with kinematic bodies.
#include "core/physics/state/VerifyState.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace rubble;

namespace {

constexpr double kSpeeds[] = {0.001, 0.01, 0.03, 0.3, 1.0};  // m/s
constexpr double kCarriedSeconds = 20.0;

std::optional<std::string> stateFault(const World& world) { return verifyState(world.snapshot()->state); }

/// A kinematic plate whose top is the plane y = 0, and a box that stands on it at x.
struct PlateWorld {
    explicit PlateWorld(double x = 0.0, Vec3 velocity = Vec3(0.0), Vec3 angularVelocity = Vec3(0.0)) {
        plate = *world.addBody({.shape = test::boxShape({100.0, 0.2, 8.0}),
                                .kind = BodyKind::Kinematic,
                                .pose = {Vec3(0.0, -0.1, 0.0)},
                                .velocity = velocity,
                                .angularVelocity = angularVelocity});
        box = *world.addBody({.shape = test::boxShape(Vec3(0.5)), .pose = {Vec3(x, 0.25, 0.0)}});
    }
    Vec3 boxPosition() const { return world.state(box).pose.position; }

    World world;
    BodyId plate, box;
};

void verifyCarried(double actual, double expected) {
    QVERIFY2(std::abs(actual - expected) <= 0.01 * expected,
             qPrintable(QString("%1 instead of %2").arg(actual).arg(expected)));
}

void addSpeeds() {
    QTest::addColumn<double>("speed");
    for (const double speed : kSpeeds) QTest::addRow("%g m/s", speed) << speed;
}

}  // namespace

class KinematicTest : public QObject {
    Q_OBJECT
private slots:
    void beltsCarry_data() { addSpeeds(); }
    void beltsCarry() {
        QFETCH(double, speed);
        PlateWorld belt(0.0, {speed, 0.0, 0.0});
        test::simulate(belt.world, kCarriedSeconds);
        verifyCarried(belt.boxPosition().x, speed * kCarriedSeconds);
        QVERIFY(!belt.world.state(belt.box).asleep);
    }
    void liftsCarry_data() { addSpeeds(); }
    void liftsCarry() {
        QFETCH(double, speed);
        for (const double direction : {1.0, -1.0}) {
            PlateWorld lift(0.0, {0.0, direction * speed, 0.0});
            test::simulate(lift.world, kCarriedSeconds);
            verifyCarried(direction * (lift.boxPosition().y - 0.25), speed * kCarriedSeconds);
            QVERIFY(!lift.world.state(lift.box).asleep);
        }
    }
    void turntablesCarry_data() { addSpeeds(); }
    void turntablesCarry() {
        QFETCH(double, speed);
        PlateWorld table(1.0, Vec3(0.0), {0.0, speed, 0.0});
        test::simulate(table.world, kCarriedSeconds);
        const double angle = speed * kCarriedSeconds;
        const Quat rotation = table.world.state(table.box).pose.orientation;
        for (const double turned :
             {std::atan2(-table.boxPosition().z, table.boxPosition().x), 2.0 * std::atan2(rotation.y, rotation.w)}) {
            verifyCarried(angle + std::remainder(turned - angle, 2.0 * std::numbers::pi), angle);
        }
    }
    /// A door comes to touch a box that sleeps, and pushes it.
    void doorsPush_data() { addSpeeds(); }
    void doorsPush() {
        QFETCH(double, speed);
        PlateWorld floor;
        test::simulate(floor.world, 2.0);
        QVERIFY(floor.world.state(floor.box).asleep);
        constexpr double kGap = 0.001;  // m, to the box
        (void)floor.world.addBody({.shape = test::boxShape({0.1, 2.0, 2.0}),
                                   .kind = BodyKind::Kinematic,
                                   .pose = {Vec3(-0.3 - kGap, 1.0, 0.0)},
                                   .velocity = {speed, 0.0, 0.0}});
        test::simulate(floor.world, kCarriedSeconds);
        const double expected = speed * kCarriedSeconds - kGap, actual = floor.boxPosition().x;
        QVERIFY2(std::abs(actual - expected) <= 0.01 * speed * kCarriedSeconds + 1e-4,
                 qPrintable(QString("%1 instead of %2").arg(actual).arg(expected)));
    }
    void beltsCarryStacks() {
        PlateWorld belt(0.0, {0.01, 0.0, 0.0});
        std::vector<BodyId> boxes;
        for (int k = 1; k < 4; ++k) {
            const Pose pose{Vec3(0.0, 0.25 + 0.5 * k, 0.0)};
            boxes.push_back(*belt.world.addBody({.shape = test::boxShape(Vec3(0.5)), .pose = pose}));
        }
        test::simulate(belt.world, kCarriedSeconds);
        for (const BodyId box : boxes) verifyCarried(belt.world.state(box).pose.position.x, 0.01 * kCarriedSeconds);
    }
    void bodiesSleepOnWhatDoesNotMove() {
        PlateWorld plate;
        test::simulate(plate.world, 2.0);
        QVERIFY(plate.world.state(plate.box).asleep);
        QVERIFY(!stateFault(plate.world));
    }
    void settingAVelocityWakes() {
        PlateWorld plate;
        test::simulate(plate.world, 2.0);
        QVERIFY(plate.world.setVelocity(plate.plate, Vec3(0.0), Vec3(0.0)));
        QVERIFY(plate.world.state(plate.box).asleep);
        QVERIFY(plate.world.setVelocity(plate.plate, {0.001, 0.0, 0.0}, Vec3(0.0)));
        QVERIFY(!plate.world.state(plate.box).asleep);
        test::simulate(plate.world, kCarriedSeconds);
        verifyCarried(plate.boxPosition().x, 0.001 * kCarriedSeconds);
        QVERIFY(plate.world.setVelocity(plate.plate, Vec3(0.0), Vec3(0.0)));
        test::simulate(plate.world, 2.0);
        QVERIFY(plate.world.state(plate.box).asleep);
        QVERIFY(!stateFault(plate.world));
    }
    void snapshotsOfCarriedBodiesGoOnAlike() {
        PlateWorld belt(0.0, {0.02, 0.0, 0.0});
        test::simulate(belt.world, 0.3);
        const auto snapshot = belt.world.snapshot();
        test::simulate(belt.world, 2.0);
        const ContentHash hash = belt.world.hash();
        belt.world.restore(*snapshot);
        test::simulate(belt.world, 2.0);
        QVERIFY(belt.world.hash() == hash);
    }
};

RUBBLE_TEST(KinematicTest)
#include "KinematicTest.moc"
