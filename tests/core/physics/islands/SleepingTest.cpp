#include "core/physics/islands/Sleeping.h"

#include "core/base/Random.h"
#include "core/physics/world/Bodies.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

using namespace rubble;

namespace {

/// `count` bodies without contacts, numbered from 1.
WorldState stateOf(std::uint32_t count) {
    WorldState state;
    state.colours.resizeBodies(1);
    const std::shared_ptr<const Shape> shape = test::boxShape({1.0, 1.0, 1.0});
    for (std::uint32_t body = 0; body < count; ++body) addBody(state, {.shape = shape});
    updateAwakeBodies(state);
    return state;
}

/// How many seconds a body stays awake whose pose and motion are set at each time; 10 if it never sleeps.
template <class Move>
double secondsAwake(const Move& move) {
    constexpr float kStep = 1.0f / 60.0f;
    WorldState state = stateOf(1);
    for (int step = 0; step < 600; ++step) {
        const float time = static_cast<float>(step) * kStep;
        move(state.poses[1], state.motions[1], time);
        updateRestTime(state, 1, kStep);
        sleepRestingIslands(state);
        if (state.awake.empty()) return static_cast<double>(time);
    }
    return 10.0;
}

/// Puts all bodies to sleep, each in an island of its own.
void sleepAll(WorldState& state) {
    for (const std::uint32_t body : state.awake) updateRestTime(state, body, 1.0f);
    sleepRestingIslands(state);
}

std::vector<std::uint32_t> ascending(std::uint32_t count) {
    std::vector<std::uint32_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 1u);
    return numbers;
}

}  // namespace

class SleepingTest : public QObject {
    Q_OBJECT
private slots:
    void restingBodiesSleepInIslandsOfTheirOwn() {
        WorldState state = stateOf(3);
        sleepAll(state);
        QVERIFY(state.awake.empty());
        std::set<std::uint32_t> islands;
        for (const std::uint32_t body : ascending(3)) islands.insert(state.bodies[body].sleepingIsland);
        QCOMPARE(islands.size(), std::size_t{3});
        QVERIFY(!islands.contains(kNone));
    }
    /// Oscillating at 8 Hz: always too fast to be at rest, but for the turning points.
    void bodiesThatStayInOnePlaceSleep_data() {
        QTest::addColumn<float>("distance");
        QTest::addColumn<float>("angle");
        QTest::addColumn<double>("least");
        QTest::addColumn<double>("most");
        QTest::newRow("at rest") << 0.0f << 0.0f << 0.4 << 0.6;
        QTest::newRow("rattling") << 0.005f << 0.002f << 2.5 << 3.5;
        QTest::newRow("rocking") << 0.0f << 0.01f << 2.5 << 3.5;
        QTest::newRow("bouncing") << 0.05f << 0.0f << 10.0 << 10.0;
        QTest::newRow("swinging") << 0.0f << 0.1f << 10.0 << 10.0;
    }
    void bodiesThatStayInOnePlaceSleep() {
        QFETCH(float, distance);
        QFETCH(float, angle);
        QFETCH(double, least);
        QFETCH(double, most);
        const double seconds = secondsAwake([&](BodyPose& pose, BodyMotion& motion, float time) {
            const float phase = 50.0f * time, s = std::sin(phase), c = 50.0f * std::cos(phase);
            pose.centre = Vec3f(0.0f, distance * s, 0.0f);
            motion.velocity = Vec3f(0.0f, distance * c, 0.0f);
            pose.rotation = Quatf{0.5f * angle * s, 0.0f, 0.0f, 1.0f}.normalized();
            motion.angularVelocity = Vec3f(angle * c, 0.0f, 0.0f);
        });
        QVERIFY2(seconds >= least && seconds <= most, qPrintable(QString("%1 s").arg(seconds)));
    }
    /// A turn in each step leaves the pose as it was.
    void bodiesThatRotateByFullTurnsStayAwake() {
        const double seconds = secondsAwake(
            [](BodyPose&, BodyMotion& motion, float) { motion.angularVelocity = Vec3f(0.0f, 377.0f, 0.0f); });
        QCOMPARE(seconds, 10.0);
    }
    void wokenBodiesAreAwakeAfterTheUpdate() {
        WorldState state = stateOf(3);
        sleepAll(state);
        wakeBody(state, 3);
        wakeBody(state, 1);
        QVERIFY(state.bodies[3].isAwake);
        QVERIFY(state.awake.empty());
        updateAwakeBodies(state);
        QCOMPARE(state.awake, (std::vector<std::uint32_t>{1, 3}));
    }
    /// No wake may move elements of the sorted list: each appends one, and one update merges all of them.
    void wakingManyIslandsMovesEachBodyOnce() {
        constexpr std::uint32_t kCount = 65536;
        WorldState state = stateOf(kCount);
        sleepAll(state);
        std::size_t listed = 0;
        for (std::uint32_t body = kCount; body > 0; --body) {
            wakeBody(state, body);
            ++listed;
            if (state.woken.size() != listed || state.woken.back() != body || !state.awake.empty())
                QFAIL(qPrintable(QString("waking body %1 changes more than the end of a list").arg(body)));
        }
        QCOMPARE(updateAwakeBodies(state), std::size_t{kCount});
        QCOMPARE(state.awake, ascending(kCount));
        QCOMPARE(updateAwakeBodies(state), std::size_t{0});
    }
    /// The same of removing bodies, whose indices are reused.
    void removingManyBodiesReadsTheListOnce() {
        constexpr std::uint32_t kCount = 4096;
        WorldState state = stateOf(kCount);
        for (std::uint32_t body = 1; body <= kCount; ++body) {
            removeBody(state, body);
            if (state.awake.size() != kCount) QFAIL("removing a body changes the list of awake bodies");
        }
        addBody(state, {.shape = test::boxShape({1.0, 1.0, 1.0})});
        QCOMPARE(updateAwakeBodies(state), std::size_t{1});
        QCOMPARE(state.awake, (std::vector<std::uint32_t>{kCount}));
    }
    void randomWakesSleepsAndRemovalsMatchASet() {
        const std::uint64_t seed = 77;
        qInfo("seed %llu", static_cast<unsigned long long>(seed));
        Random random(seed);
        WorldState state = stateOf(40);
        const std::shared_ptr<const Shape> shape = test::boxShape({1.0, 1.0, 1.0});
        for (int round = 0; round < 3000; ++round) {
            const auto body = static_cast<std::uint32_t>(1 + random.below(state.bodies.size() - 1));
            const bool isAlive = state.bodies[body].shape != nullptr;
            switch (random.below(5)) {
                case 0:
                    if (isAlive) removeBody(state, body);
                    break;
                case 1:
                    if (state.bodies.size() < 80 || !state.freeBodies.empty()) addBody(state, {.shape = shape});
                    break;
                case 2:
                    updateAwakeBodies(state);
                    sleepAll(state);
                    break;
                case 3: updateAwakeBodies(state); break;
                default:
                    if (isAlive) wakeBody(state, body);
            }
            if (round % 7 != 0) continue;
            updateAwakeBodies(state);
            std::vector<std::uint32_t> expected;
            for (std::uint32_t k = 1; k < state.bodies.size(); ++k)
                if (state.bodies[k].shape != nullptr && state.bodies[k].isAwake) expected.push_back(k);
            QCOMPARE(state.awake, expected);
        }
    }
};

RUBBLE_TEST(SleepingTest)
#include "SleepingTest.moc"
