// Tests core/play/analysis/HitForecast.cpp.
#include "core/play/analysis/HitForecast.h"

#include "core/play/analysis/RequirementShot.h"
#include "core/play/analysis/ThresholdInterval.h"
#include "core/play/session/StandingParts.h"
#include "tests/support/Closeness.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/BondedWalls.h"

using namespace rubble;

namespace {

constexpr auto kHole = RequirementOutcome::HoleAtMost;

/// A wall that is held, with a random pattern, half of them with clusters; half of them on the ground, half without
/// gravity.
Project randomWall(Random& random, std::uint64_t seed) {
    const auto pieces = 30 + static_cast<std::uint32_t>(random.below(200));
    Project project = seed % 2 == 0 ? test::bondedWall(pieces) : test::clusteredWall(pieces, 6);
    if (seed % 4 < 2) {
        project.gravity = Vec3(0.0);
        project.ground.isOn = false;
    }
    project.instances[0].isAnchored = false;
    project.instances[0].isFixed = true;
    Asset& asset = project.assets[0];
    asset.bonding.radius = random.between(0.2, 1.5);
    asset.bonding.damageFrom = random.between(0.3, 1.0);
    if (seed % 2 == 0) asset.pattern.layers[0].randomSeed = seed;
    return project;
}

HitForecast forecastOf(const Project& project, const StrengthRequirement& requirement) {
    const auto scene = test::playSceneOf(project);
    const std::shared_ptr<const PlayAsset> asset = scene->assets.begin()->second;
    return {playStructure(project.assets[0], project.materials[0], asset, kNone),
            *requirementImpact(project, *asset, requirement)};
}

/// The width of the hole that has come off the held wall in play `time` s after the event of a requirement, m.
double playedHole(Project project, const StrengthRequirement& requirement, double impulsePerArea, double time) {
    project.assets[0].bonding.impulsePerArea = impulsePerArea;
    Session session = test::sessionOf(project, {.dt = 1.0 / 240.0});
    const PlayAsset asset = test::onlyAsset(session.scene());
    test::addInput(session, ShotInput{"event", *requirementShot(project, asset, requirement, &project.instances[0])});
    for (double now = 0.0; now < time; now += 1.0 / 240.0) session.step();
    const std::vector<std::uint32_t> held = fragmentsOf(*session.body(project.ground.isOn ? 1 : 0));
    if (held.empty()) return 0.0;
    return holeWidth(*session.scene().structures.at(project.instances[0].id), held);
}

}  // namespace

class HitForecastTest : public QObject {
    Q_OBJECT
private slots:
    void holesAreNoWiderFromTheStrengthOn() {
        for (std::uint64_t seed = 0; seed < 60; ++seed) {
            Random random(seed);
            const Project project = randomWall(random, seed);
            const HitForecast forecast = forecastOf(project, {kHole, ImpulseRequirement{random.between(10.0, 1000.0)}});
            const double width = random.between(0.2, 3.0), strength = forecast.strengthFor(width);
            QVERIFY2(strength <= forecast.breaking(), QByteArray::number(seed));
            if (strength == 0.0) continue;
            QVERIFY2(forecast.hole(strength) <= width, QByteArray::number(seed));
            QVERIFY2(forecast.hole(strength * (1.0 - 1e-5)) > width, QByteArray::number(seed));
            QVERIFY2(forecast.lost(1.01 * forecast.breaking()).empty(), QByteArray::number(seed));
        }
    }
    /// A stronger structure can lose a wider part than a weaker one, where another part is the heaviest then.
    void noStrengthAboveLeavesAWiderHole() {
        int widened = 0;
        for (std::uint64_t seed = 0; seed < 20; ++seed) {
            Random random(seed);
            Project project = randomWall(random, 2 * seed);
            project.assets[0].bonding.radius = random.between(0.5, 4.0);
            const HitForecast forecast = forecastOf(project, {kHole, ImpulseRequirement{1000.0}});
            const double width = random.between(0.5, 4.5), strength = forecast.strengthFor(width);
            double earlier = 1e300;
            for (double tried = 1e-4 * forecast.breaking(); tried < 1.1 * forecast.breaking(); tried *= 1.013) {
                const double hole = forecast.hole(tried);
                widened += hole > earlier + 1e-9 ? 1 : 0;
                earlier = hole;
                QVERIFY2(tried < strength || hole <= width, QByteArray::number(seed));
            }
        }
        qInfo("%d holes are wider than those of a weaker wall", widened);
        QVERIFY(widened > 0);
    }
    void looseFragmentsAreAHoleOfAnyStrength() {
        Project project = test::bondedWall(60);
        project.assets[0].bonding.heightStrengths = {{0.0, 1.0}, {1.5, 1.0}, {1.6, 0.0}};
        const StrengthRequirement requirement{kHole, ImpulseRequirement{10.0}, 0.5};
        QVERIFY(std::isinf(forecastOf(project, requirement).strengthFor(0.5)));
        project.assets[0].requirements = {requirement};
        const auto asset = test::playSceneOf(project)->assets.begin()->second;
        const ThresholdInterval interval = bondInterval(project, asset).value();
        QVERIFY(interval.isEmpty() && !interval.suggested());
        QCOMPARE(conflictText(project.assets[0], interval).value(),
                 std::string("\"gets a hole of at most 0.5 m at an impulse of 10 N·s\" cannot be met: as much is "
                             "loose before anything is hit."));
    }
    void playLeavesTheSameHoles() {
        int agreeing = 0, tried = 0;
        for (std::uint64_t seed = 0; seed < 60; ++seed) {
            Random random(seed);
            const Project project = randomWall(random, seed);
            StrengthRequirement requirement{kHole, ImpulseRequirement{random.between(50.0, 1000.0)}, 0.0};
            if (random.below(2) == 0)
                requirement.event = HitRequirement{random.between(5.0, 200.0), random.between(2.0, 20.0)};
            requirement.hole = random.between(0.4, 2.0);
            const double strength = 100.0 * forecastOf(project, requirement).strengthFor(requirement.hole);
            if (strength == 0.0) continue;
            for (const double factor : {0.9, 1.1}) {
                const double hole = playedHole(project, requirement, factor * strength, 1.0);
                const bool isWider = hole > requirement.hole;
                agreeing += isWider == (factor < 1.0) ? 1 : 0;
                if (isWider != (factor < 1.0)) {
                    qInfo("seed %d, %s: a factor of %g leaves %g m of %g", static_cast<int>(seed),
                          requirement.event.index() == 1 ? "hit" : "impulse", factor, hole, requirement.hole);
                }
                ++tried;
            }
        }
        qInfo("%d of %d agree", agreeing, tried);
        QVERIFY(tried >= 80 && agreeing >= 95 * tried / 100);
    }
};

RUBBLE_TEST_WITH(HitForecastTest, QCoreApplication)
#include "HitForecastTest.moc"
