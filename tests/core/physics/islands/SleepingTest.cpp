#include "core/physics/islands/Sleeping.h"

#include "core/base/Random.h"
#include "core/physics/world/Bodies.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

#include <algorithm>
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

/// Puts all bodies to sleep, each in an island of its own.
void sleepAll(WorldState& state) {
    for (const std::uint32_t body : state.awake) updateRestTime(state, body, {}, 1.0f);
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
    /// What rattles is at rest, but not when something other than a new contact disturbed it.
    void whatIsWokenIsAtRestNoMore() {
        WorldState state = stateOf(1);
        Body& body = state.bodies[1];
        state.gravity = Vec3f(0.0f, -9.81f, 0.0f);
        body.stayTime = 1.0f;
        body.stayReach = 0.001f;
        body.stayPath = 1.0f;
        QVERIFY(isAtRest(state, 1));
        wakeBody(state, 1);
        QVERIFY(!isAtRest(state, 1));
    }
};

RUBBLE_TEST(SleepingTest)
#include "SleepingTest.moc"
