// Tests core/play/analysis/ThresholdInterval.cpp and core/play/analysis/RequirementImpulse.cpp.
#include "core/play/analysis/ThresholdInterval.h"

#include "core/play/analysis/RequirementImpulse.h"
#include "tests/support/Closeness.h"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/RandomAssets.h"
#include "tests/support/play/BondedWalls.h"
#include "tests/support/play/Sessions.h"

using namespace rubble;
using test::floatingBlock;
using test::onlyAsset;

namespace {

constexpr auto kSurvives = RequirementOutcome::Survives;
constexpr auto kBreaks = RequirementOutcome::Breaks;

/// A block of 500 kg, falling down and free to be hit.
Project block() {
    Project project = floatingBlock();
    project.gravity = {0.0, -9.81, 0.0};
    return project;
}

double impulseOf(const Project& project, const StrengthRequirement& requirement) {
    const Result<double> impulse = requirementImpulse(project, onlyAsset(*test::playSceneOf(project)), requirement);
    if (!impulse) qFatal("%s", impulse.error().message.c_str());
    return *impulse;
}

std::string faultOf(const Project& project, const StrengthRequirement& requirement) {
    return errorText(requirementImpulse(project, onlyAsset(*test::playSceneOf(project)), requirement));
}

/// What a real drop from a height, or a throw from near by, does to the only asset.
struct Trial {
    double damage = 0.0;
    bool isBroken = false;
};

Trial tried(Project project, const StrengthRequirement& requirement, double threshold, double dt) {
    Asset& asset = project.assets[0];
    asset.threshold = threshold;
    double lowest = 0.0;
    for (const Vec2& corner : asset.prism().outline.outer) lowest = std::min(lowest, corner.y);
    const DropRequirement* drop = std::get_if<DropRequirement>(&requirement.event);
    const Vec3 place(0.0, drop != nullptr ? drop->height - lowest : 10.0, 0.0);
    test::addInstance(project, asset.id, "asset", {.position = place});
    Session session = test::sessionOf(project, {.dt = dt});
    if (drop == nullptr) {
        const auto& hit = std::get<HitRequirement>(requirement.event);
        Throw thrown = hitThrow(project, onlyAsset(session.scene()), hit);
        thrown.from += place + Vec3(0.0, 0.0, 0.3);
        thrown.to += place;
        test::addInput(session, ShotInput{"cube", thrown});
    }
    for (double time = 0.0; time < 2.0 && session.events().impacts.empty(); time += dt) session.step();
    if (session.events().impacts.empty()) return {};
    const auto& [breaks, impacts] = std::tie(session.events().breaks, session.events().impacts);
    // The first impact: a body that turns over it may hit harder in the same step.
    return {impacts[0].damage, !breaks.empty() && breaks[0].impact == impacts[0].damage};
}

StrengthRequirement randomIntent(Random& random) {
    const RequirementOutcome outcome = random.below(2) == 0 ? kSurvives : kBreaks;
    if (random.below(2) == 0) return {outcome, DropRequirement{random.between(0.3, 3.0)}};
    return {outcome, HitRequirement{random.between(0.5, 200.0), random.between(1.5, 30.0)}};
}

/// Whether a hit of a cube breaks a bond of a free, bonded wall, in play.
bool breaksBond(Project project, const HitRequirement& hit, double impulsePerArea) {
    project.assets[0].bonding.impulsePerArea = impulsePerArea;
    Session session = test::sessionOf(project, {.dt = 1.0 / 240.0});
    const Vec3 place = project.instances[0].pose.position;
    Throw thrown = hitThrow(project, onlyAsset(session.scene()), hit);
    thrown.from += place + Vec3(0.0, 0.0, 0.3);
    thrown.to += place;
    test::addInput(session, ShotInput{"cube", thrown});
    for (int k = 0; k < 120 && session.events().impacts.empty(); ++k) session.step();
    const auto hasBonds = [](const PlaySplit& split) { return split.bonds > 0; };
    return std::ranges::any_of(session.events().splits, hasBonds);
}

}  // namespace

class ThresholdIntervalTest : public QObject {
    Q_OBJECT
private slots:
    void bondsBreakFromTheirFigureOn() {
        int agreeing = 0, tried = 0;
        for (std::uint64_t seed = 0; seed < 50; ++seed) {
            Random random(seed);
            const auto pieces = 20 + static_cast<std::uint32_t>(random.below(60));
            Project project = seed % 2 == 0 ? test::bondedWall(pieces) : test::clusteredWall(pieces, 5);
            project.gravity = Vec3(0.0);
            project.ground.isOn = false;
            project.instances[0].isAnchored = false;
            if (seed % 2 == 0) project.assets[0].pattern.layers[0].randomSeed = seed;
            const HitRequirement hit{random.between(5.0, 200.0), random.between(2.0, 20.0)};
            project.assets[0].requirements = {{kSurvives, hit}};
            const std::shared_ptr<const PlayScene> scene = test::playSceneOf(project);
            const Result<ThresholdInterval> interval = bondInterval(project, scene->assets.begin()->second);
            QVERIFY2(interval.hasValue(), errorText(interval).c_str());
            QVERIFY(interval->isPerArea && interval->low > 0.0 && interval->lowRequirement == 0);
            for (const double factor : {0.9, 1.1}) {
                const bool breaks = breaksBond(project, hit, factor * interval->low);
                agreeing += breaks == (factor < 1.0) ? 1 : 0;
                if (breaks != (factor < 1.0)) qInfo("seed %d: a factor of %g", static_cast<int>(seed), factor);
                ++tried;
            }
        }
        QVERIFY2(agreeing >= 95 * tried / 100, qPrintable(QString("%1 of %2").arg(agreeing).arg(tried)));
        qInfo("%d of %d agree", agreeing, tried);
    }
    void figuresOfBondsGrowWithTheImpulse() {
        Project project = test::bondedWall(60, 100.0);
        project.assets[0].requirements = {{kSurvives, ImpulseRequirement{100.0}}, {kBreaks, ImpulseRequirement{300.0}}};
        const auto asset = test::playSceneOf(project)->assets.begin()->second;
        const ThresholdInterval interval = bondInterval(project, asset).value();
        QVERIFY(isNear(interval.impulses[1], 3.0 * interval.impulses[0], 1e-9));
        QVERIFY(!interval.isEmpty() && interval.contains(*interval.suggested()));
        QCOMPARE(intervalText(interval),
                 "above " + impulseText(interval.low, true) + " and at most " + impulseText(interval.high, true));
        project.assets[0].bonding.impulsePerArea = 25.0;  // the figures do not depend on what it is now
        const auto weak = test::playSceneOf(project)->assets.begin()->second;
        QVERIFY(isNear(bondInterval(project, weak).value().low, interval.low, 1e-9));
    }
    void dropStopsTheWholeMass() {
        QVERIFY(isNear(impulseOf(block(), {kSurvives, DropRequirement{1.0}}), 500.0 * std::sqrt(2.0 * 9.81), 1e-4));
    }
    void hitUsesBothMasses() {
        QVERIFY(
            isNear(impulseOf(block(), {kBreaks, HitRequirement{5.0, 12.0}}), 12.0 / (1.0 / 5.0 + 1.0 / 500.0), 1e-4));
    }
    void largerRestitutionIsUsed() {
        Project project = block();
        project.materials[0].restitution = 0.2;
        project.ground.restitution = 0.5;
        QVERIFY(
            isNear(impulseOf(project, {kSurvives, DropRequirement{1.0}}), 1.5 * 500.0 * std::sqrt(2.0 * 9.81), 1e-4));
        QVERIFY(isNear(impulseOf(project, {kSurvives, HitRequirement{500.0, 2.0}}), 1.2 * 500.0, 1e-4));
        QVERIFY(isNear(impulseOf(project, {kSurvives, HitRequirement{500.0, 0.9}}), 225.0, 1e-4));  // too slow for it
    }
    void slowContactHasNoImpulse() {
        QCOMPARE(impulseOf(block(), {kSurvives, DropRequirement{0.01}}), 0.0);
        QCOMPARE(impulseOf(block(), {kSurvives, HitRequirement{5.0, 0.4}}), 0.0);
    }
    /// A frame of 4 x 4 m with a window of 2 x 2 m is hit at the window's rim, 1 m beside its centre, by a cube of 0.2
    /// m of which one half finds something to hit: at 1.05 m. There the frame turns away.
    void hitUsesTheNearestPointOfAnOpenMiddle() {
        Project project = block();
        project.assets[0].shape = Prism{squareRing(), 0.5};
        const double mass = 1000.0 * 12.0 * 0.5, inertia = mass * ((16.0 * 4.0 - 4.0) / 12.0 / 12.0 + 0.25 / 12.0);
        const double cube = 20.0, cubeInertia = cube * 0.04 / 6.0;
        const Throw thrown = hitThrow(project, onlyAsset(*test::playSceneOf(project)), {cube, 10.0});
        QVERIFY(std::abs(glm::distance(Vec2(thrown.from), Vec2(2.0, 2.0)) - 1.0004) < 1e-6);
        const double inverseEffectiveMass = 1.0 / mass + 1.05 * 1.05 / inertia + 1.0 / cube + 0.05 * 0.05 / cubeInertia;
        const double impulse = impulseOf(project, {kBreaks, HitRequirement{cube, 10.0}});
        QVERIFY2(std::abs(impulse - 10.0 / inverseEffectiveMass) < 0.01 * impulse,
                 QByteArray::number(impulse * inverseEffectiveMass / 10.0));
    }
    void damageRuleOfTheProjectIsUsed() {
        Project project = block();
        project.damage.rule = DamageRule::Momentum;
        QVERIFY(isNear(impulseOf(project, {kBreaks, HitRequirement{5.0, 12.0}}), 60.0, 1e-4));
    }
    void impulsesAreRoundedTowardsTheStricterSide() {
        const auto impulseOf = [](RequirementOutcome outcome, double impulse) {
            return std::get<ImpulseRequirement>(impulseRequirement(outcome, impulse).event).impulse;
        };
        QCOMPARE(impulseOf(RequirementOutcome::Breaks, 71.98), 71.9);
        QCOMPARE(impulseOf(RequirementOutcome::Survives, 71.92), 72.0);
        QCOMPARE(impulseOf(RequirementOutcome::Survives, 0.0012345), 0.00124);
        QCOMPARE(impulseOf(RequirementOutcome::Breaks, 1234567.0), 1230000.0);
        QCOMPARE(requirementText(impulseRequirement(RequirementOutcome::Breaks, 71.98)),
                 std::string("breaks at an impulse of 71.9 N·s"));
        QCOMPARE(requirementText(impulseRequirement(RequirementOutcome::Survives, 71.92)),
                 std::string("survives an impulse of 72 N·s"));
    }
    void impulsesBoundTheThresholdThemselves() {
        Project project = test::floatingBlock();
        project.assets[0].requirements = {impulseRequirement(RequirementOutcome::Survives, 30.0),
                                          impulseRequirement(RequirementOutcome::Breaks, 72.0)};
        const auto baked = std::make_shared<const Bake>(bake(project.assets[0]).value());
        const Result<ThresholdInterval> interval =
            thresholdInterval(project, wholePlayAsset(project.assets[0], baked).value());
        QVERIFY(interval);
        QCOMPARE(interval->low, 30.0);
        QCOMPARE(interval->high, 72.0);
    }
    void invalidRequirementsAreRejected() {
        Project project = block();
        QCOMPARE(faultOf(project, {kBreaks, HitRequirement{1e20, 1.0}}),
                 std::string("The projectile is too light or too heavy to be simulated."));
        QCOMPARE(faultOf(project, {kBreaks, HitRequirement{1.0, 1e5}}),
                 std::string("The velocity of a body must be below 10 km/s."));
        for (const Vec3 gravity : {Vec3(0.0), Vec3(1.0, -9.0, 0.0), Vec3(0.0, 9.81, 0.0)}) {
            project.gravity = gravity;
            QCOMPARE(faultOf(project, {kBreaks, DropRequirement{1.0}}),
                     std::string("A drop needs gravity that points straight down, along -y."));
            QCOMPARE(faultOf(project, {kBreaks, HitRequirement{1.0, 1.0}}), std::string());
        }
    }

    void requirementsGiveAnInterval() {
        Project project = block();
        project.assets[0].requirements = {{kSurvives, HitRequirement{5.0, 12.0}},
                                          {kSurvives, DropRequirement{0.2}},
                                          {kBreaks, DropRequirement{1.0}},
                                          {kBreaks, HitRequirement{400.0, 50.0}}};
        const Result<ThresholdInterval> interval = thresholdInterval(project, onlyAsset(*test::playSceneOf(project)));
        QVERIFY(interval.hasValue() && interval->impulses.size() == 4);
        QCOMPARE(interval->lowRequirement, 1u);
        QCOMPARE(interval->highRequirement, 2u);
        QVERIFY(isNear(interval->low, 500.0 * std::sqrt(0.4 * 9.81), 1e-4));
        QVERIFY(isNear(interval->high, 500.0 * std::sqrt(2.0 * 9.81), 1e-4));
        QVERIFY(interval->contains(interval->high) && !interval->contains(interval->low));
        QVERIFY(interval->contains(*interval->suggested()));
        QCOMPARE(intervalText(*interval), std::string("above 990.5 N·s and at most 2215 N·s"));
        QCOMPARE(conflictText(project.assets[0], *interval).value_or(""), std::string());
    }
    void conflictingRequirementsAreNamed() {
        Project project = block();
        project.assets[0].requirements = {{kSurvives, DropRequirement{1.0}}, {kBreaks, HitRequirement{5.0, 12.0}}};
        const Result<ThresholdInterval> interval = thresholdInterval(project, onlyAsset(*test::playSceneOf(project)));
        QVERIFY(interval.hasValue() && interval->isEmpty() && !interval->suggested());
        QCOMPARE(
            conflictText(project.assets[0], *interval).value_or(""),
            std::string("\"survives a drop of 1 m\" needs a threshold above 2215 N·s, \"breaks when hit by 5 kg at "
                        "12 m/s\" one of at most 59.41 N·s: they are 2155 N·s (3628 %) apart."));
        project.assets[0].requirements = {{kBreaks, DropRequirement{0.01}}};
        const Result<ThresholdInterval> none = thresholdInterval(project, onlyAsset(*test::playSceneOf(project)));
        QVERIFY(none.hasValue() && none->isEmpty());
        QCOMPARE(conflictText(project.assets[0], *none).value_or(""),
                 std::string("\"breaks in a drop of 0.01 m\" cannot be met: such a slow contact does no damage."));
    }
    void bondedAssetHasNoThreshold() {
        Project project = block();
        project.assets[0].breakAs = BreakAs::Bonded;
        const auto interval = [&] { return thresholdInterval(project, onlyAsset(*test::playSceneOf(project))); };
        QCOMPARE(
            interval().error().message,
            std::string(
                "Asset \"block\": This asset breaks along bonds: its requirements bound the impulse per area, not a "
                "threshold."));
        project.damage.isThesis = true;
        QVERIFY(interval().hasValue());
    }
    void suggestionWithOneOrNoBound() {
        Project project = block();
        const auto interval = [&] { return *thresholdInterval(project, onlyAsset(*test::playSceneOf(project))); };
        QVERIFY(!interval().suggested() && intervalText(interval()) == "any");
        project.assets[0].requirements = {{kSurvives, DropRequirement{1.0}}};
        QVERIFY(interval().contains(*interval().suggested()) && *interval().suggested() > 1.2 * interval().low);
        project.assets[0].requirements = {{kBreaks, DropRequirement{1.0}}};
        QVERIFY(interval().contains(*interval().suggested()) && *interval().suggested() < 0.9 * interval().high);
    }
    void faultsNameTheAsset() {
        Project project = block();
        project.gravity = Vec3(0.0);
        project.assets[0].requirements = {{kSurvives, DropRequirement{1.0}}};
        const Result<ThresholdInterval> interval = thresholdInterval(project, onlyAsset(*test::playSceneOf(project)));
        QVERIFY(!interval);
        QCOMPARE(interval.error().message, std::string("Asset \"block\": A drop needs gravity that "
                                                       "points straight down, along -y."));
    }

    /// Real falls and throws keep to both ends of the interval to 1 %: 1.01 times the impulse survives, 0.99 times
    /// breaks. At 1/60 s a fall is slower than it should be: after n sub-steps v^2 = 2 g h n / (n + 1), which is 0.8 %
    /// of the impulse from 0.3 m and 0.3 % from 3 m.
    void fiftyRequirementsHoldInSessions_data() {
        QTest::addColumn<int>("stepsASecond");
        QTest::newRow("1/60 s") << 60;
        QTest::newRow("1/240 s") << 240;
    }
    void fiftyRequirementsHoldInSessions() {
        QFETCH(int, stepsASecond);
        constexpr std::uint64_t kSeed = 20;
        qInfo("seed %d", static_cast<int>(kSeed));
        Random random(kSeed);
        double worst = 0.0;
        for (int sentence = 0; sentence < 50; ++sentence) {
            const Project project = test::randomAsset(random, sentence);
            const StrengthRequirement requirement = randomIntent(random);
            const double impulse = impulseOf(project, requirement);
            const Trial above = tried(project, requirement, 1.01 * impulse, 1.0 / stepsASecond);
            const Trial below = tried(project, requirement, 0.99 * impulse, 1.0 / stepsASecond);
            worst = std::max(worst, std::abs(above.damage / impulse - 1.0));
            const std::string event = std::to_string(sentence) + ": " + requirementText(requirement) + ", " +
                                      impulseText(impulse) + " against " + impulseText(above.damage);
            QVERIFY2(!above.isBroken && below.isBroken, event.c_str());
        }
        qInfo("worst impulse: off by %.3f %%", 100.0 * worst);
    }
};

RUBBLE_TEST_WITH(ThresholdIntervalTest, QCoreApplication)
#include "ThresholdIntervalTest.moc"
