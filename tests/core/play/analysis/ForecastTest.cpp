#include "core/play/analysis/Forecast.h"

#include "core/base/Random.h"
#include "core/base/math/Trigonometry.h"
#include "core/play/session/Aim.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/House.h"
#include "tests/support/play/BondedWalls.h"

#include <array>
#include <cstdlib>
#include <numbers>
#include <set>

using namespace rubble;
using test::addInput;
using test::floatingBlock;
using test::sessionOf;
using test::throwAtBlock;

namespace {

ForecastOrder orderOf(const std::shared_ptr<const PlayScene>& scene, const Session& session, const Throw& thrown) {
    return {scene, {.threads = 2}, session.snapshot(), thrown};
}

std::vector<BodyForecast> forecastOf(const Project& project, const Throw& thrown,
                                     const SessionSettings& settings = {}) {
    const std::shared_ptr<const PlayScene> scene = test::playSceneOf(project);
    const Session session = Session::start(scene, settings).value();
    Result<std::vector<BodyForecast>> forecast = breakForecast(orderOf(scene, session, thrown));
    if (!forecast) qFatal("%s", forecast.error().message.c_str());
    return std::move(*forecast);
}

/// How many bodies were shown in a colour, and how many did what it says.
struct Promises {
    int shown = 0;
    int kept = 0;
    void count(bool isKept) {
        ++shown;
        kept += isKept ? 1 : 0;
    }
    double fraction() const { return shown == 0 ? 1.0 : static_cast<double>(kept) / shown; }
};

/// An eye in front of the house, of ten around it.
Vec3 eyeAt(int number) {
    const double angle = 2.0 * std::numbers::pi * number / 10.0;
    return {18.0 * sine(angle), 2.0 + 1.3 * number, 18.0 * cosine(angle)};
}

}  // namespace

class ForecastTest : public QObject {
    Q_OBJECT
private slots:
    /// A block of 500 kg that breaks at 100 N·s.
    void headOnImpactUsesBothMasses() {
        const std::vector<BodyForecast> bodies = forecastOf(floatingBlock(), throwAtBlock(20.0, 12.0));
        QCOMPARE(bodies.size(), std::size_t{1});
        QCOMPARE(bodies[0].body, 1u);
        QVERIFY(std::abs(bodies[0].largest / (12.0 / (1.0 / 20.0 + 1.0 / 500.0) / 100.0) - 1.0) < 0.01);
    }
    void weakThrowsBreakNothing() {
        const std::vector<BodyForecast> bodies = forecastOf(floatingBlock(), throwAtBlock(2.0, 12.0));
        QCOMPARE(bodies.size(), std::size_t{1});
        QVERIFY(bodies[0].largest > 0.2 && bodies[0].largest < 0.3);
    }
    void bondsBreakAtOne() {
        const auto wallIn = [](const Throw& thrown) {
            const std::vector<BodyForecast> bodies = forecastOf(test::bondedWall(), thrown);
            const auto wall = std::ranges::find(bodies, 1u, &BodyForecast::body);
            return wall != bodies.end() ? wall->largest : 0.0;
        };
        QVERIFY(wallIn(test::ballAtWall()) >= 1.0);
        const double weak = wallIn(test::ballAtWall({0.0, 1.8}, 0.02, 20.0));
        QVERIFY2(weak > 0.0 && weak < 1.0, QByteArray::number(weak));
        QCOMPARE(wallIn(test::ballAtWall({0.0, 9.0})), 0.0);  // over it
    }
    /// Throws of 20 g to 4 kg at the same wall, of which each may damage what the next meets.
    void bondedWallKeepsThePromises() {
        constexpr std::uint64_t kSeed = 5;
        qInfo("seed %d", static_cast<int>(kSeed));
        Random random(kSeed);
        const std::shared_ptr<const PlayScene> scene = test::playSceneOf(test::bondedWall(150));
        Session session = Session::start(scene).value();
        std::array<int, 2> count{};
        for (int k = 0; k < 40; ++k) {
            const double mass = std::array{0.02, 0.05, 0.1, 0.3, 4.0}[random.below(5)];
            const Throw thrown = test::ballAtWall({random.between(-1.7, 1.7), random.between(0.3, 2.7)}, mass,
                                                  random.between(5.0, 25.0));
            const auto bodies = breakForecast(orderOf(scene, session, thrown)).value();
            addInput(session, ShotInput{"throw", thrown});
            bool isBroken = false;
            for (int step = 0; step < 240; ++step) {
                session.step();
                for (const PlaySplit& split : session.events().splits) isBroken |= split.body.number == 1;
            }
            const auto wall = std::ranges::find(bodies, 1u, &BodyForecast::body);
            QCOMPARE(wall != bodies.end() && wall->largest >= 1.0, isBroken);
            ++count[isBroken ? 1 : 0];
        }
        qInfo("%d throws broke bonds, %d did not", count[1], count[0]);
        QVERIFY(count[0] >= 5 && count[1] >= 5);
    }
    void missesAreEmpty() {
        Throw past = throwAtBlock(20.0, 12.0);
        past.to.x = 3.0;
        QVERIFY(forecastOf(floatingBlock(), past).empty());
    }
    void nothingBreaksWithoutDestruction() {
        const std::vector<BodyForecast> bodies =
            forecastOf(floatingBlock(), throwAtBlock(20.0, 12.0), {.hasDestruction = false});
        QCOMPARE(bodies.size(), std::size_t{1});
        QVERIFY(bodies[0].largest < 1.0);
    }
    void invalidThrowsAndCancellationAreErrors() {
        const std::shared_ptr<const PlayScene> scene = test::playSceneOf(floatingBlock());
        const Session session = Session::start(scene).value();
        QCOMPARE(breakForecast(orderOf(scene, session, throwAtBlock(-1.0, 12.0))).error().code, ErrorCode::BadInput);
        const TaskContext task;
        task.cancel.cancel();
        QCOMPARE(breakForecast(orderOf(scene, session, throwAtBlock(20.0, 12.0)), task).error().code,
                 ErrorCode::Cancelled);
    }
    void refinementsGrowIntoTheResult() {
        const std::shared_ptr<const PlayScene> scene = test::playSceneOf(floatingBlock());
        const Session session = Session::start(scene).value();
        std::vector<std::vector<BodyForecast>> refined;
        const auto result = breakForecast(orderOf(scene, session, throwAtBlock(20.0, 12.0)), {},
                                          [&](const std::vector<BodyForecast>& bodies) { refined.push_back(bodies); });
        QCOMPARE(refined.size(), std::size_t{1});  // the only impact: nothing changes after it
        QCOMPARE(refined.back().size(), result->size());
        QCOMPARE(refined.back()[0].largest, result->at(0).largest);
    }
    void refinementsDifferFromEachOther() {
        const std::shared_ptr<const PlayScene> scene = test::playSceneOf(test::house());
        const Session session = Session::start(scene).value();
        Throw thrown{.size = Vec3(0.6), .mass = 1500.0, .speed = 22.0};
        thrown = throwAlong(session, thrown, {Vec3(0.0, 2.0, 18.0), Vec3(0.0, 0.0, -1.0)});
        std::vector<std::vector<BodyForecast>> refined;
        QVERIFY(breakForecast(orderOf(scene, session, thrown), {},
                              [&](const std::vector<BodyForecast>& bodies) { refined.push_back(bodies); }));
        QVERIFY(refined.size() > 1);
        for (std::size_t i = 1; i < refined.size(); ++i) QVERIFY(refined[i] != refined[i - 1]);
    }
    /// Aims at the house from ten eyes with three projectiles, thrown up to a fifth of a second after the forecast, and
    /// watched for twice as long. The forecast in closed form was wrong in 63 of 120 aims. RUBBLE_LONG: 500 aims, else
    /// 30.
    void simulationKeepsThePromises() {
        constexpr std::uint64_t kSeed = 7;
        const int aims = std::getenv("RUBBLE_LONG") != nullptr ? 500 : 30;
        qInfo("seed %d", static_cast<int>(kSeed));
        Random random(kSeed);
        const std::shared_ptr<const PlayScene> scene = test::playSceneOf(test::house());
        Session session = Session::start(scene).value();
        for (int step = 0; step < 30; ++step) session.step();
        const std::shared_ptr<const SessionSnapshot> start = session.snapshot();
        Promises breaking, safe, targets;
        for (int aim = 0; aim < aims; ++aim) {
            session.restore(*start);
            const Vec3 eye = eyeAt(aim % 10);
            const Vec3 point(random.between(-2.4, 2.4), random.between(0.3, 5.0), random.between(-2.9, 2.9));
            const Ray ray{eye, glm::normalize(point - eye)};
            Throw thrown{.size = Vec3(0.6),
                         .mass = std::array{200.0, 600.0, 1500.0}[static_cast<std::size_t>(aim % 3)]};
            thrown.speed = aim % 2 == 0 ? 22.0 : reachingSpeed(session, thrown, ray);
            thrown = throwAlong(session, thrown, ray);
            const std::optional<CastHit> hit = firstHit(session.world(), ray);
            const std::uint64_t target = hit ? session.world().tag(hit->body) : 0;
            const auto bodies = breakForecast(orderOf(scene, session, thrown)).value();
            for (int late = 0; late < aim % 12; ++late) session.step();
            addInput(session, ShotInput{"throw", thrown});
            std::set<std::uint32_t> broken;
            for (const PlayBreak& one : test::breaksWithin(session, 480)) broken.insert(one.body.number);
            for (std::uint32_t number = 1; number <= 77; ++number) {
                const auto reported = std::ranges::find(bodies, number, &BodyForecast::body);
                const bool isShown = reported != bodies.end() && reported->largest >= 1.0,
                           isBroken = broken.contains(number);
                (isShown ? breaking : safe).count(isBroken == isShown);
                if (number == target) targets.count(isBroken == isShown);
            }
        }
        qInfo("shown as breaking: %d, of which %.2f %% break; as safe: %d, of which %.2f %% stay whole", breaking.shown,
              100.0 * breaking.fraction(), safe.shown, 100.0 * safe.fraction());
        qInfo("targets: %d, of which %.2f %% do as they are shown", targets.shown, 100.0 * targets.fraction());
        QVERIFY(targets.shown >= aims / 2 && targets.fraction() >= 0.98);
        QVERIFY(breaking.fraction() >= 0.95);
        QVERIFY(safe.fraction() >= 0.98);
    }
};

RUBBLE_TEST(ForecastTest)
#include "ForecastTest.moc"
