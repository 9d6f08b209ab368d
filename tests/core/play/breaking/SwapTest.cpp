#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/House.h"
#include "tests/support/asset/Pane.h"
#include "tests/support/play/Sessions.h"

#include <algorithm>
#include <set>
#include <variant>

using namespace rubble;

namespace {

double fastest(const Session& session) {
    double speed = 0.0;
    for (const PlayBody& body : session.bodies()) {
        speed = std::max(speed, glm::length(session.world().state(body.body).velocity));
    }
    return speed;
}

/// One asset of a project by itself, at rest: afloat without gravity, or lying flat on the ground.
Session atRest(Project project, const Asset& asset, bool isFloating) {
    project.instances.clear();
    project.shots.clear();
    project.playTests.clear();
    if (isFloating) project.gravity = Vec3(0.0);
    const double height = isFloating ? 5.0 : asset.prism().depth / 2.0;
    const double half = std::sqrt(0.5);
    test::addInstance(project, asset.id, "it", {{0.0, height, 0.0}, Quat{half, -half, 0.0, 0.0}});
    return test::sessionOf(project, {.sleeping = false});
}

/// How fast the fastest piece is half a second after the whole was swapped for them by no force, m/s.
double speedAfterSwap(Session& session) {
    for (int step = 0; step < 60; ++step) session.step();
    test::addInput(session, BreakInput{session.bodies()[1].number});
    for (int step = 0; step < 30; ++step) session.step();
    return fastest(session);
}

const std::string kChaoticShot = "block under the roof";

/// What a shot breaks within a second.
struct Broken {
    std::set<std::string> first;     // within a step of the coarsest rate
    std::set<std::string> decisive;  // by at least twice its threshold, while fragments are still in the air
    std::set<std::string> all;
};

Broken brokenBy(const std::shared_ptr<const PlayScene>& scene, const Shot& shot, int rate) {
    constexpr double kCoarsestStep = 1.0 / 60.0, kFlight = 0.5;  // s
    constexpr double kDecisive = 2.0;
    Session session = Session::start(scene, {.dt = 1.0 / rate}).value();
    if (!session.add(shot)) qFatal("The shot cannot be fired.");
    Broken broken;
    double firstTime = 0.0;
    for (const PlayBreak& one : test::breaksWithin(session, rate + rate / 2)) {  // shots are fired after half a second
        const double time = static_cast<double>(one.step) / rate;
        const std::string name = session.nameOf(one.body);
        if (broken.all.empty()) firstTime = time;
        if (time < firstTime + kCoarsestStep) broken.first.insert(name);
        if (time < firstTime + kFlight && one.impact >= kDecisive * one.threshold) broken.decisive.insert(name);
        broken.all.insert(name);
    }
    return broken;
}

}  // namespace

class SwapTest : public QObject {
    Q_OBJECT
private slots:
    void swapWithoutForceMovesNothing() {
        for (const Project& project : {test::house(), test::pane()}) {
            for (const Asset& asset : project.assets) {
                Session session = atRest(project, asset, true);
                const double speed = speedAfterSwap(session);
                qInfo("%s: %.3g mm/s", asset.name.c_str(), 1e3 * speed);
                QVERIFY(test::countOf(session, PlayRole::Debris) > 1);
                QVERIFY(speed < 1e-3);
                QVERIFY(session.world().momenta().kinetic < 1e-6);
            }
        }
    }
    void swapUnderGravityHardlyMovesAFlatAsset() {
        for (const Project& project : {test::house(), test::pane()}) {
            for (const Asset& asset : project.assets) {
                Session session = atRest(project, asset, false);
                const double speed = speedAfterSwap(session);
                qInfo("%s: %.3g mm/s", asset.name.c_str(), 1e3 * speed);
                QVERIFY(speed < 1e-2);
            }
        }
    }
    void breaksAreIndependentOfTheStepLength() {
        const std::shared_ptr<const PlayScene> scene = test::playSceneOf(test::house());
        for (const Shot& shot : scene->project.shots) {
            const Broken expected = brokenBy(scene, shot, 60);
            for (const int rate : {120, 240}) {
                const Broken broken = brokenBy(scene, shot, rate);
                QCOMPARE(broken.first, expected.first);
                QCOMPARE(broken.decisive, expected.decisive);
                if (shot.name != kChaoticShot) QCOMPARE(broken.all, expected.all);
            }
        }
    }
    /// Why that shot is left out above. The heavy block drives the fragments of the four blocks that it hits across the
    /// house. These hit the far wall 0.4 s later with 1.0 to 1.7 times the thresholds of its blocks: whether one breaks
    /// depends on how a piece tumbles and which of its corners comes first. A real wall would be no different: with the
    /// same steps, a millimetre more to one side changes what breaks, but not what the block itself breaks. Beside the
    /// hole it grazes two more blocks, with up to 1.6 times their thresholds if steps are short, with less than them if
    /// not.
    void farBreaksOfAHeavyBlockDependOnAMillimetre() {
        constexpr int kRate = 120;
        std::set<std::set<std::string>> all;
        std::set<std::string> decisive;
        for (const double shift : {-1e-3, 0.0, 1e-3}) {
            Project project = test::house();
            const auto shot = std::ranges::find(project.shots, kChaoticShot, &Shot::name);
            Throw& thrown = std::get<Throw>(shot->action);
            thrown.from.z += shift;
            thrown.to.z += shift;
            const Broken broken = brokenBy(test::playSceneOf(project), *shot, kRate);
            if (decisive.empty()) decisive = broken.decisive;
            QCOMPARE(broken.decisive, decisive);
            all.insert(broken.all);
        }
        QCOMPARE(decisive, (std::set<std::string>{"left 3.2", "left 3.3", "left 4.2", "left 4.3"}));
        QVERIFY2(all.size() > 1, "no longer sensitive: compare all breaks in breaksAreIndependentOfTheStepLength()");
    }
    /// Over many throws that differ by up to 10 cm, what that shot breaks does not depend on the step length: the means
    /// at all rates are within a sixth of each other, where single throws at one rate vary by more.
    void meanBreaksAreIndependentOfTheStepLength() {
        constexpr int kThrows = 24;
        std::vector<double> means;
        for (const int rate : {60, 120, 240}) {
            Random random(5);
            double breaks = 0.0;
            for (int k = 0; k < kThrows; ++k) {
                Project project = test::house();
                const auto shot = std::ranges::find(project.shots, kChaoticShot, &Shot::name);
                Throw& thrown = std::get<Throw>(shot->action);
                const auto shift = [&] { return random.between(-0.1, 0.1); };
                thrown.from += Vec3{shift(), shift(), shift()};
                thrown.to += Vec3{shift(), shift(), shift()};
                breaks += static_cast<double>(brokenBy(test::playSceneOf(project), *shot, rate).all.size());
            }
            means.push_back(breaks / kThrows);
            qInfo("%d Hz: %.2f breaks", rate, means.back());
        }
        const auto [least, most] = std::ranges::minmax(means);
        QVERIFY(least > 5.0);
        QVERIFY(most < 7.0 / 6.0 * least);
    }
    void memoryStaysBoundedOverTenMinutes() {
        constexpr int kSeconds = 600;
        Project project = test::house();
        project.debris = {.lifetime = 20.0, .maxFragments = 300};
        Session session = test::sessionOf(project);
        Random random(5);
        for (int second = 0; second < kSeconds; ++second) {
            test::addInput(session,
                           ShotInput{"box", Throw{.size = Vec3(0.6),
                                                  .mass = 200.0,
                                                  .from = {random.between(-8.0, 8.0), random.between(2.0, 5.0), 12.0},
                                                  .to = {random.between(-2.0, 2.0), random.between(1.0, 4.0), 0.0},
                                                  .speed = 25.0}});
            for (int step = 0; step < 60; ++step) session.step();
            QVERIFY(std::isfinite(session.world().momenta().kinetic));
            QVERIFY(test::countOf(session, PlayRole::Debris) <= 300);
            QVERIFY(session.bodies().size() <= 1 + 77 + 300 + static_cast<std::size_t>(second + 1));  // boxes stay
        }
        QVERIFY(test::countOf(session, PlayRole::Instance) < 77);
    }
};

RUBBLE_TEST(SwapTest)
#include "SwapTest.moc"
