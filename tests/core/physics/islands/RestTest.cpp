#include "core/physics/islands/Rest.h"

#include "core/physics/islands/Sleeping.h"
#include "core/physics/world/Bodies.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

#include <cmath>
#include <numbers>

using namespace rubble;

namespace {

constexpr double kGravity = 9.81;    // m/s²
constexpr double kAwake = 30.0;      // s: what never rests
constexpr double kFrequency = 50.0;  // rad/s: 8 Hz

/// The displacement, m, and rotation, rad, of a body at a time, s.
struct Movement {
    double displacement = 0.0;
    double angle = 0.0;
};

/// How many seconds a cube of 1 m takes to be at rest that moves along and about the x-axis; kAwake if it never is.
template <class Move>
double secondsToRest(const Move& move, double gravity = kGravity) {
    constexpr double kStep = 1.0 / 60.0, kDelta = 1e-5;
    WorldState state;
    state.gravity = Vec3f(0.0f, static_cast<float>(-gravity), 0.0f);
    state.colours.resizeBodies(1);
    const std::uint32_t body = addBody(state, {.shape = test::boxShape({1.0, 1.0, 1.0})});
    BodyMotion& motion = state.motions[body];
    BodyPose& pose = state.poses[body];
    for (int step = 0; step < static_cast<int>(kAwake / kStep); ++step) {
        const double time = step * kStep, end = time + kStep;
        const Movement from = move(time), to = move(end), before = move(end - kDelta), after = move(end + kDelta);
        const auto along = [](double x) { return Vec3f(static_cast<float>(x), 0.0f, 0.0f); };
        motion.velocity = along((after.displacement - before.displacement) / (2.0 * kDelta));
        motion.angularVelocity = along((after.angle - before.angle) / (2.0 * kDelta));
        pose.centre = along(to.displacement);
        pose.rotation = Quatf{static_cast<float>(std::sin(0.5 * to.angle)), 0.0f, 0.0f,
                              static_cast<float>(std::cos(0.5 * to.angle))};
        updateRestTime(state, body, {along(to.displacement - from.displacement), along(to.angle - from.angle)},
                       static_cast<float>(kStep));
        if (isAtRest(state, body)) return end;
    }
    return kAwake;
}

double swing(double time) { return std::sin(kFrequency * time); }

}  // namespace

class RestTest : public QObject {
    Q_OBJECT
private slots:
    void bodiesThatStayInOnePlaceRest_data() {
        QTest::addColumn<double>("distance");
        QTest::addColumn<double>("angle");
        QTest::addColumn<double>("least");
        QTest::addColumn<double>("most");
        QTest::newRow("still") << 0.0 << 0.0 << 0.4 << 0.6;
        QTest::newRow("trembling") << 0.0002 << 0.0 << 0.4 << 0.6;
        QTest::newRow("rattling a little") << 0.002 << 0.0 << 0.4 << 0.8;
        QTest::newRow("rattling") << 0.005 << 0.002 << 0.5 << 1.0;
        QTest::newRow("rocking") << 0.0 << 0.01 << 0.5 << 1.3;
        QTest::newRow("bouncing") << 0.05 << 0.0 << kAwake << kAwake;
        QTest::newRow("swinging") << 0.0 << 0.1 << kAwake << kAwake;
    }
    void bodiesThatStayInOnePlaceRest() {
        QFETCH(double, distance);
        QFETCH(double, angle);
        QFETCH(double, least);
        QFETCH(double, most);
        const double seconds = secondsToRest([&](double time) {
            return Movement{distance * swing(time), angle * swing(time)};
        });
        QVERIFY2(seconds >= least && seconds <= most, qPrintable(QString("%1 s").arg(seconds)));
    }
    /// A body that was moving rests half a second after it stopped.
    void bodiesThatStoppedRest() {
        for (const double distance : {0.0005, 0.002, 0.01, 0.1}) {
            const double seconds = secondsToRest([&](double time) { return Movement{distance * std::min(1.0, time)}; });
            QVERIFY2(seconds <= 1.6, qPrintable(QString("%1 m: %2 s").arg(distance).arg(seconds)));
        }
    }
    /// By a hundredth of gravity and less, from rest and after having slowed down.
    void bodiesThatAccelerateNeverRest() {
        for (const double gravity : {0.01, 0.1, 1.62, 9.81, 25.0}) {
            for (const double fraction : {0.002, 0.0068, 0.01, 0.1}) {
                for (const double turn : {0.0, 0.2, 1.0, 3.0}) {  // s: when it stands still
                    if (turn > 0.0 && fraction < 0.006) continue;
                    const double seconds = secondsToRest(
                        [&](double time) { return Movement{0.5 * fraction * gravity * (time - turn) * (time - turn)}; },
                        gravity);
                    QVERIFY2(seconds == kAwake, qPrintable(QString("%1 of %2 m/s², %3 s: after %4 s")
                                                               .arg(fraction)
                                                               .arg(gravity)
                                                               .arg(turn)
                                                               .arg(seconds)));
                }
            }
        }
    }
    void bodiesThatDriftNeverRest() {
        for (const double speed : {0.004, 0.005, 0.01, 0.04}) {
            QCOMPARE(secondsToRest([&](double time) { return Movement{speed * time}; }), kAwake);
            QCOMPARE(secondsToRest([&](double time) { return Movement{0.0, speed * time}; }), kAwake);
            // While it trembles.
            QCOMPARE(secondsToRest([&](double time) { return Movement{speed * time + 0.0003 * swing(time)}; }), kAwake);
        }
    }
    void withoutGravityOnlyWhatDoesNotMoveRests() {
        const auto secondsAt = [](double speed) {
            return secondsToRest([&](double time) { return Movement{speed * time}; }, 0.0);
        };
        QVERIFY(secondsAt(0.0) < 0.6);
        for (const double speed : {1e-5, 1e-4, 1e-3, 1e-2}) QCOMPARE(secondsAt(speed), kAwake);
        QCOMPARE(secondsToRest([](double time) { return Movement{0.0005 * swing(time)}; }, 0.0), kAwake);
    }
    /// A turn in each step leaves the pose as it was.
    void bodiesThatRotateByFullTurnsNeverRest() {
        QCOMPARE(secondsToRest([](double time) { return Movement{0.0, 120.0 * std::numbers::pi * time}; }), kAwake);
    }
};

RUBBLE_TEST(RestTest)
#include "RestTest.moc"
