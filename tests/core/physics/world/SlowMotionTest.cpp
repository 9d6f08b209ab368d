// Tests core/physics/islands/Rest.cpp and core/physics/step/Solver.cpp.
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace rubble;

namespace {

constexpr double kGravities[] = {0.01, 0.1, 1.62, 9.81, 25.0};  // m/s²
constexpr double kSizes[] = {0.01, 0.1, 1.0, 3.0, 10.0};        // m
constexpr double kRadians = std::numbers::pi / 180.0;

Quat slope(double degrees) { return glm::angleAxis(-degrees * kRadians, Vec3(0.0, 0.0, 1.0)); }

/// A box that stands on a slope, whose surface contains the origin and falls towards +x.
struct SlopeWorld {
    SlopeWorld(double degrees, double friction, Vec3 sides, double gravity)
        : world({.gravity = {0.0, -gravity, 0.0}}), down(slope(degrees) * Vec3(1.0, 0.0, 0.0)) {
        const Quat rotation = slope(degrees);
        (void)world.addBody({.shape = test::boxShape({12.0 + 4.0 * sides.x, 2.0, 4.0 * sides.x}),
                             .kind = BodyKind::Static,
                             .pose = {rotation * Vec3(0.0, -1.0, 0.0), rotation},
                             .friction = friction});
        const Pose pose{rotation * Vec3(0.0, 0.5 * sides.y, 0.0), rotation};
        body = *world.addBody({.shape = test::boxShape(sides), .pose = pose, .friction = friction});
    }
    /// How far down the slope the body has slid, m.
    double slid() const { return glm::dot(world.state(body).pose.position, down); }

    World world;
    Vec3 down;
    BodyId body;
};

/// How far a body gets from rest with an acceleration, m/s²: a little farther than a t² / 2, by the sub-steps.
double accelerated(double acceleration, double seconds) {
    constexpr double kSubStep = test::kStep / 4.0;
    return 0.5 * acceleration * seconds * (seconds + kSubStep);
}

/// The time that a slab on its edge takes from an angle past its balance to another, s; both from the vertical.
double tippingTime(double from, double to, double distance, double gravity) {
    // I α = m g d sin(angle), where I = 4/3 m d² about the edge.
    double time = 0.0, angle = from, speed = 0.0;
    const double dt = 1e-4 * std::sqrt(distance / gravity), stiffness = 0.75 * gravity / distance;
    for (; angle < to; time += dt) angle += dt * (speed += dt * stiffness * std::sin(angle));
    return time;
}

bool isWithinOnePercent(double actual, double expected) {
    return std::abs(actual - expected) <= 0.01 * std::abs(expected);
}

void verifyOnePercent(double actual, double expected, const QString& what) {
    QVERIFY2(isWithinOnePercent(actual, expected),
             qPrintable(QString("%1: %2 instead of %3").arg(what).arg(actual).arg(expected)));
}

}  // namespace

/// Bodies that move slowly move as theory has it: none falls asleep.
class SlowMotionTest : public QObject {
    Q_OBJECT
private slots:
    void bodiesFallAtAnyGravity() {
        for (const double gravity : kGravities) {
            for (const double size : kSizes) {
                World world({.gravity = {0.0, -gravity, 0.0}});
                const BodyId body = *world.addBody({.shape = test::boxShape(Vec3(size))});
                const double seconds = std::round(60.0 * std::sqrt(2.0 * 5.0 / gravity)) / 60.0;
                test::simulate(world, seconds);
                verifyOnePercent(-world.state(body).pose.position.y, accelerated(gravity, seconds),
                                 QString("%1 m at %2 m/s²").arg(size).arg(gravity));
            }
        }
    }
    /// At the highest point of its way a body is slow.
    void bodiesThrownUpReturn() {
        for (const double gravity : kGravities) {
            World world({.gravity = {0.0, -gravity, 0.0}});
            const double speed = std::sqrt(2.0 * gravity * 0.5);
            const BodyId body = *world.addBody({.shape = test::boxShape(Vec3(0.1)), .velocity = {0.0, speed, 0.0}});
            const double seconds = std::round(60.0 * 3.0 * speed / gravity) / 60.0;
            test::simulate(world, seconds);
            verifyOnePercent(world.state(body).velocity.y, speed - gravity * seconds, QString("%1 m/s²").arg(gravity));
        }
    }
    void bodiesDriftWithoutGravity() {
        for (const double speed : {1e-4, 1e-3, 1e-2, 0.04}) {
            for (const double size : kSizes) {
                World world({.gravity = Vec3(0.0)});
                const BodyId body = *world.addBody({.shape = test::boxShape(Vec3(size)),
                                                    .pose = {Vec3(5.0, 0.0, 0.0)},
                                                    .velocity = {speed, 0.0, 0.0}});
                test::simulate(world, 20.0);
                verifyOnePercent(world.state(body).pose.position.x - 5.0, 20.0 * speed,
                                 QString("%1 m at %2 m/s").arg(size).arg(speed));
            }
        }
    }
    void bodiesRotateWithoutGravity() {
        for (const double size : kSizes) {
            World world({.gravity = Vec3(0.0)});
            const double speed = 0.05 / size;  // rad/s: 5 for a cube of 1 cm
            const BodyId body =
                *world.addBody({.shape = test::boxShape(Vec3(size)), .angularVelocity = {0.0, 0.0, speed}});
            test::simulate(world, 20.0);
            const Quat rotation = world.state(body).pose.orientation;
            const double angle =
                std::remainder(2.0 * std::atan2(rotation.z, rotation.w) - 20.0 * speed, 2.0 * std::numbers::pi);
            QVERIFY2(std::abs(angle) < std::min(0.05, 0.01 * 20.0 * speed), qPrintable(QString::number(angle)));
        }
    }
    void bodiesHeldInTheAirFallWhenReleased() {
        World world;
        const BodyId body = *world.addBody({.shape = test::boxShape(Vec3(0.5))});
        QVERIFY(world.grab(body, Vec3(0.0), 1e6));
        test::simulate(world, 5.0);
        const double held = world.state(body).pose.position.y;
        QVERIFY(!world.state(body).asleep);
        QVERIFY(glm::length(world.state(body).velocity) < 1e-3);
        world.release();
        test::simulate(world, 1.0);
        verifyOnePercent(held - world.state(body).pose.position.y, accelerated(9.81, 1.0), "released");
    }
    void bodiesSlideOnIce() {
        for (const double degrees : {0.1, 0.4, 1.0, 5.0, 20.0}) {
            for (const double gravity : kGravities) {
                for (const double size : kSizes) {
                    SlopeWorld ice(degrees, 0.0, Vec3(size, 0.5 * size, size), gravity);
                    const double acceleration = gravity * std::sin(degrees * kRadians);
                    const double seconds = std::round(60.0 * std::sqrt(2.0 * 0.5 / acceleration)) / 60.0;
                    test::simulate(ice.world, seconds);
                    verifyOnePercent(ice.slid(), accelerated(acceleration, seconds),
                                     QString("%1 m at %2° and %3 m/s²").arg(size).arg(degrees).arg(gravity));
                }
            }
        }
    }
    void bodiesSlideOnSlopesSteeperThanTheirFriction() {
        constexpr double kFriction = 0.6;  // holds up to 30.96°
        for (const double degrees : {31.3, 32.0, 35.0, 40.0, 50.0}) {
            for (const double gravity : kGravities) {
                for (const double size : kSizes) {
                    SlopeWorld slope(degrees, kFriction, Vec3(size, 0.25 * size, size), gravity);
                    const double angle = degrees * kRadians;
                    const double acceleration = gravity * (std::sin(angle) - kFriction * std::cos(angle));
                    const double seconds = std::round(60.0 * std::sqrt(2.0 * 2.0 / acceleration)) / 60.0;
                    test::simulate(slope.world, seconds);
                    verifyOnePercent(slope.slid(), accelerated(acceleration, seconds),
                                     QString("%1 m at %2° and %3 m/s²").arg(size).arg(degrees).arg(gravity));
                }
            }
        }
    }
    void bodiesSleepOnSlopesThatTheirFrictionHolds() {
        for (const double degrees : {0.0, 5.0, 20.0, 30.0, 30.6}) {
            for (const double gravity : kGravities) {
                for (const double size : kSizes) {
                    SlopeWorld slope(degrees, 0.6, Vec3(size, 0.25 * size, size), gravity);
                    test::simulate(slope.world, 2.0);
                    const QString what = QString("%1 m at %2° and %3 m/s²").arg(size).arg(degrees).arg(gravity);
                    QVERIFY2(slope.world.state(slope.body).asleep, qPrintable(what));
                    QVERIFY2(std::abs(slope.slid()) < 0.02 * size + 1e-4,
                             qPrintable(QString("%1: %2 m").arg(what).arg(slope.slid())));
                }
            }
        }
    }
    void slabsPastTheirBalanceTip() {
        constexpr double kFlat = 45.0 * kRadians;
        for (const double degrees : {0.3, 1.0, 3.0}) {
            for (const double gravity : kGravities) {
                for (const double size : {0.1, 1.0, 3.0, 10.0}) {
                    if (degrees * size < 0.09) continue;  // the edge sinks into a soft contact by as much
                    const Vec3 sides(0.1 * size, size, 0.3 * size);
                    const double distance = 0.5 * std::hypot(sides.x, sides.y), past = degrees * kRadians;
                    SlopeWorld floor(0.0, 1.0, sides, gravity);
                    // On its lower edge at +x, its centre past it.
                    const Quat rotation = slope((std::atan2(sides.x, sides.y) + past) / kRadians);
                    const Vec3 edge = rotation * Vec3(0.5 * sides.x, -0.5 * sides.y, 0.0);
                    QVERIFY(floor.world.setPose(floor.body, {-edge, rotation}));
                    const double expected = tippingTime(past, kFlat, distance, gravity);
                    double seconds = 0.0;
                    for (; seconds < 2.0 * expected; seconds += test::kStep) {
                        const BodyState state = floor.world.state(floor.body);
                        if (state.centre.y < distance * std::cos(kFlat)) break;
                        floor.world.step(test::kStep);
                    }
                    const QString what = QString("%1 m at %2° and %3 m/s²").arg(size).arg(degrees).arg(gravity);
                    QVERIFY2(std::abs(seconds - expected) <= 0.01 * expected + test::kStep,
                             qPrintable(QString("%1: %2 s instead of %3").arg(what).arg(seconds).arg(expected)));
                }
            }
        }
    }
};

RUBBLE_TEST(SlowMotionTest)
#include "SlowMotionTest.moc"
