// Tests core/play/breaking/HitIntervals.cpp: the same throw breaks the same at any length of steps.
#include "core/play/breaking/HitIntervals.h"

#include "core/base/Random.h"
#include "core/base/math/Power.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/BondedWalls.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

using namespace rubble;
using namespace rubble::test;

namespace {

/// A wall that something is thrown at: bonded or whole; held, standing or floating; of any size.
Project randomTarget(Random& random) {
    const double size = power(10.0, random.between(-1.0, 0.7));
    Project project = bondedWall(8 + static_cast<std::uint32_t>(random.below(60)), random.between(20.0, 400.0));
    Asset& asset = project.assets[0];
    const double width = size * random.between(0.4, 1.5), height = size * random.between(0.4, 1.5);
    asset.shape = Prism{{rectangle({-0.5 * width, -0.5 * height}, {0.5 * width, 0.5 * height}), {}},
                        size * random.between(0.05, 0.3)};
    asset.bonding.radius = size * random.between(0.1, 0.6);
    asset.bonding.damageFrom = random.between(0.1, 1.0);
    Instance& instance = project.instances[0];
    instance.pose.position = {0.0, 0.5 * height, 0.0};
    switch (random.below(4)) {
        case 0: asset.breakAs = BreakAs::Whole; [[fallthrough]];
        case 1:  // floats
            instance.isAnchored = false;
            instance.pose.position.y = 50.0;
            project.gravity = Vec3(0.0);
            break;
        case 2: instance.isAnchored = false; break;  // stands
        default: break;                              // is held
    }
    return project;
}

/// A throw at a target: a hit of a few times what breaks something.
Throw randomThrow(const Project& project, Random& random) {
    const Instance& instance = project.instances[0];
    const Prism& prism = project.assets[0].prism();
    const Vec2 corner = prism.outline.outer[2];
    const double size = 2.0 * std::max(corner.x, corner.y);
    const Vec3 at = instance.pose.position +
                    Vec3(random.between(-0.8, 0.8) * corner.x, random.between(-0.5, 0.8) * corner.y, 0.5 * prism.depth);
    const double side = size * random.between(0.08, 0.3), speed = random.between(4.0, 30.0);
    return {.kind = random.below(2) == 0 ? ProjectileKind::Ball : ProjectileKind::Box,
            .size = Vec3(side),
            .mass = side * side * side * random.between(500.0, 6000.0),
            .from = at + Vec3(size * random.between(-0.4, 0.4), 0.0, side + size * random.between(0.2, 1.0)),
            .to = at,
            .speed = speed};
}

double timeOf(const Session& session) { return static_cast<double>(session.stepsDone()) * session.stepLength(); }

/// What broke until a time, by name, and the impulse of the first break.
struct Broken {
    std::set<std::string> names;  // bonds that are broken, and fragments that are bodies
    double impulse = 0.0;
    double time = 0.0;   // s, of that
    double until = 0.0;  // s
};

/// Until a time that is a multiple of all steps: `until`, or, if that is 0, the first one kAfter after the first break.
Broken brokenBy(const Project& project, const Throw& thrown, double dt, double until) {
    constexpr double kLongest = 2.0, kAfter = 0.05, kRounding = 1e-6;  // s
    Session session = sessionOf(project, {.dt = dt});
    addInput(session, ShotInput{"throw", thrown});
    Broken broken;
    while (timeOf(session) < (until > 0.0 ? until : kLongest) - kRounding) {
        session.step();
        const double time = timeOf(session);
        const PlayEvents& events = session.events();
        if (broken.time == 0.0 && !(events.breaks.empty() && events.splits.empty())) {
            broken.time = time;
            broken.impulse = events.breaks.empty() ? events.splits[0].impulse : events.breaks[0].impact;
        }
        if (until == 0.0 && broken.time > 0.0) until = std::ceil((broken.time + kAfter) * 30.0) / 30.0;
    }
    broken.until = timeOf(session);
    for (const StructureState& state : session.structures()) {
        for (std::size_t bond = 0; bond < state.damage.size(); ++bond) {
            if (state.damage[bond] == kBroken) broken.names.insert("bond " + std::to_string(bond));
        }
    }
    for (const PlayBody& body : session.bodies()) {
        if (body.role == PlayRole::Debris) broken.names.insert(session.nameOf(body));
    }
    return broken;
}

double jaccard(const std::set<std::string>& a, const std::set<std::string>& b) {
    std::vector<std::string> both;
    std::ranges::set_intersection(a, b, std::back_inserter(both));
    const std::size_t either = a.size() + b.size() - both.size();
    return either == 0 ? 1.0 : static_cast<double>(both.size()) / static_cast<double>(either);
}

}  // namespace

class HitIntervalsTest : public QObject {
    Q_OBJECT
private slots:
    void stepsAreDividedIntoEqualIntervals() {
        QCOMPARE(hitIntervals(1.0 / 60.0), 4);
        QCOMPARE(hitIntervals(1.0 / 30.0), 8);
        QCOMPARE(hitIntervals(1.0 / 120.0), 2);
        QCOMPARE(hitIntervals(1.0 / 240.0), 1);
        QCOMPARE(hitIntervals(0.001), 1);
        QCOMPARE(hitIntervals(0.01), 3);
    }
    /// Not in the step before, in which it comes near.
    void blocksBreakInTheStepInWhichTheyLand() {
        constexpr double kGravity = 9.81, kRate = 30.0;
        for (const double drop : {1.0, 1.1, 1.2, 1.3, 1.4}) {  // the last lands 1 ms after the begin of a step
            Project project = floatingBlock();
            project.gravity = {0.0, -kGravity, 0.0};
            project.instances[0].pose.position.y = 0.5 + drop;
            Session session = sessionOf(project, {.dt = 1.0 / kRate});
            const std::vector<PlayBreak> breaks = breaksWithin(session, 30);
            QVERIFY(!breaks.empty());
            QCOMPARE(static_cast<double>(breaks[0].step), std::ceil(std::sqrt(2.0 * drop / kGravity) * kRate));
        }
    }
    void sameThrowBreaksTheSameAtAnyLengthOfSteps_data() {
        QTest::addColumn<int>("rate");
        for (const int rate : {30, 60, 120}) QTest::addRow("%d steps a second", rate) << rate;
    }
    void sameThrowBreaksTheSameAtAnyLengthOfSteps() {
        QFETCH(int, rate);
        const int rounds = qEnvironmentVariableIsSet("RUBBLE_LONG") ? 400 : 60;
        int hits = 0, same = 0;
        double sum = 0.0;
        for (int seed = 0; seed < rounds; ++seed) {
            Random random(static_cast<std::uint64_t>(seed));
            const Project project = randomTarget(random);
            const Throw thrown = randomThrow(project, random);
            const Broken expected = brokenBy(project, thrown, 1.0 / 240.0, 0.0);
            const Broken broken = brokenBy(project, thrown, 1.0 / rate, expected.until);
            if (expected.names.empty() && broken.names.empty()) continue;
            const double index = jaccard(expected.names, broken.names);
            const double ratio = broken.impulse / expected.impulse;
            if (index < 0.95 || std::abs(ratio - 1.0) > 0.03) {
                qInfo("seed %d: %zu and %zu, index %.3f, impulse %.4f, %.4f and %.4f s", seed, expected.names.size(),
                      broken.names.size(), index, ratio, expected.time, broken.time);
            }
            ++hits;
            same += index >= 0.95 ? 1 : 0;
            sum += index;
        }
        qInfo("%d hits, %d the same, mean %.4f", hits, same, sum / hits);
        QVERIFY(hits > rounds / 2);
        QVERIFY(same >= 0.95 * hits);
        QVERIFY(sum >= 0.97 * hits);
    }
};

RUBBLE_TEST(HitIntervalsTest)
#include "HitIntervalsTest.moc"
