#include "core/play/analysis/RequirementShot.h"

#include "core/play/analysis/RequirementImpulse.h"
#include "tests/support/Closeness.h"
#include "tests/support/ErrorText.h"
#include "tests/support/TestProgram.h"
#include "tests/support/play/Sessions.h"

using namespace rubble;

namespace {

using enum RequirementOutcome;
constexpr StrengthRequirement kFootball{Survives, HitRequirement{.mass = 0.43, .speed = 20.0}};

/// A wall of 2 x 1.5 x 0.1 m that stands on the ground, rotated about the vertical axis.
Project standingWall(bool isFixed = false) {
    Project project;
    const Id stone = test::addMaterial(project, {.name = "stone", .density = 1000.0, .restitution = 0.2});
    const Id wall = test::addAsset(
        project, {.name = "wall", .material = stone, .shape = Prism{{rectangle({0.0, 0.0}, {2.0, 1.5}), {}}, 0.1}},
        {UniformScatter{.count = 10}});
    const Quat rotation = glm::angleAxis(0.7, Vec3(0.0, 1.0, 0.0));
    test::addInstance(project, wall, "wall", {.position = {3.0, 0.0, -2.0}, .orientation = rotation});
    project.instances[0].isFixed = isFixed;
    project.assets[0].threshold = 1e6;
    return project;
}

/// The damage of the first impact on a body of the asset that the requirement's shot makes in play.
double playedDamage(const Project& project, const StrengthRequirement& requirement, double dt) {
    Session session = test::sessionOf(project, {.dt = dt});
    const PlayAsset& asset = test::onlyAsset(session.scene());
    const Instance* instance = instanceToTry(project, project.assets[0], requirement);
    const Result<ShotAction> shot = requirementShot(project, asset, requirement, instance);
    if (!shot) qFatal("%s", shot.error().message.c_str());
    test::addInput(session, ShotInput{"trial", *shot});
    const bool isDrop = std::holds_alternative<DropRequirement>(requirement.event);
    for (double time = 0.0; time < 2.0; time += dt) {
        session.step();
        for (const PlayImpact& impact : session.events().impacts) {
            const PlayBody* body = session.body(impact.body);
            if (body->asset != nullptr && (body->role == PlayRole::Projectile) == isDrop) return impact.damage;
        }
    }
    return 0.0;
}

double computedImpulse(const Project& project, const StrengthRequirement& requirement) {
    return requirementImpulse(project, test::onlyAsset(*test::playSceneOf(project)), requirement).value();
}

}  // namespace

class RequirementShotTest : public QObject {
    Q_OBJECT
private slots:
    void playGivesTheImpulseOfTheRequirement_data() {
        QTest::addColumn<StrengthRequirement>("requirement");
        QTest::addColumn<bool>("isFixed");
        QTest::newRow("football") << kFootball << false;
        QTest::newRow("football at a fixed wall") << kFootball << true;
        QTest::newRow("push by hand") << StrengthRequirement{Survives, HitRequirement{0.5, 1.2}} << false;
        QTest::newRow("thrown stone") << StrengthRequirement{Breaks, HitRequirement{0.05, 20.0}} << true;
        QTest::newRow("car") << StrengthRequirement{Breaks, HitRequirement{1200.0, 14.0}} << false;
        QTest::newRow("drop of 1 m") << StrengthRequirement{Survives, DropRequirement{1.0}} << false;
        QTest::newRow("drop of 0.3 m") << StrengthRequirement{Survives, DropRequirement{0.3}} << true;
        QTest::newRow("impulse") << StrengthRequirement{Breaks, ImpulseRequirement{30.0}} << false;
    }
    /// To 1 %; see ThresholdIntervalTest for falls at 1/60 s.
    void playGivesTheImpulseOfTheRequirement() {
        QFETCH(StrengthRequirement, requirement);
        QFETCH(bool, isFixed);
        for (const double dt : {1.0 / 60.0, 1.0 / 240.0}) {
            const Project project = standingWall(isFixed);
            const double impulse = computedImpulse(project, requirement);
            const double played = playedDamage(project, requirement, dt);
            QVERIFY2(isNear(played, impulse, 0.01),
                     qPrintable(QString("%1 N·s, computed %2").arg(played).arg(impulse)));
        }
    }
    void fixedInstancesGiveNoWay() {
        QVERIFY(isNear(computedImpulse(standingWall(true), kFootball), 1.2 * 0.43 * 20.0, 1e-3));
        QVERIFY(isNear(computedImpulse(standingWall(false), kFootball), 1.2 * 20.0 / (1.0 / 0.43 + 1.0 / 300.0), 1e-3));
    }
    void fixedAndFreeInstancesGetTheHarderDemand() {
        Project project = standingWall(true);
        test::addInstance(project, project.assets[0].id, "free", {.position = {9.0, 0.0, 0.0}});
        StrengthRequirement breaks = kFootball;
        breaks.outcome = Breaks;
        QCOMPARE(supportOf(project, project.assets[0], kFootball), AssetSupport::Fixed);
        QCOMPARE(supportOf(project, project.assets[0], breaks), AssetSupport::Free);
        QCOMPARE(instanceToTry(project, project.assets[0], kFootball)->name, std::string("wall"));
        QCOMPARE(instanceToTry(project, project.assets[0], breaks)->name, std::string("free"));
        QVERIFY(computedImpulse(project, kFootball) > computedImpulse(project, breaks));
    }
    void unbreakableInstancesAreNotTried() {
        Project project = standingWall();
        project.instances[0].isUnbreakable = true;
        QCOMPARE(instanceToTry(project, project.assets[0], kFootball), nullptr);
    }
    void selectedInstanceIsTried() {
        Project project = standingWall();
        test::addInstance(project, project.assets[0].id, "other", {.position = {9.0, 0.0, 0.0}});
        const Id other = project.instances[1].id;
        QCOMPARE(instanceToTry(project, project.assets[0], kFootball, other)->id, other);
        project.instances[1].threshold = 5.0;
        QCOMPARE(instanceToTry(project, project.assets[0], kFootball, other)->id, project.instances[0].id);
    }
    /// A plate of 2 x 1.5 x 0.1 m of 300 kg, hit at its corner: 1/M_eff = 1/M + 0.75² / Ix + 1² / Iy.
    void cornersTakeLess() {
        const Project project = standingWall();
        const double ix = 300.0 * (1.5 * 1.5 + 0.01) / 12.0, iy = 300.0 * (4.0 + 0.01) / 12.0;
        const double corner = 1.0 / 300.0 + 0.75 * 0.75 / ix + 1.0 / iy;
        const auto asset = test::playSceneOf(project);
        const HitRequirement hit{.mass = 100.0, .speed = 5.0};
        QVERIFY(isNear(cornerFraction(project, test::onlyAsset(*asset), hit, AssetSupport::Free),
                       (1.0 / 100.0 + 1.0 / 300.0) / (1.0 / 100.0 + corner), 1e-6));
        QCOMPARE(cornerFraction(project, test::onlyAsset(*asset), hit, AssetSupport::Fixed), 1.0);
    }
    void dropsNeedGround() {
        Project project = standingWall();
        project.ground.isOn = false;
        const auto asset = test::playSceneOf(project);
        QCOMPARE(errorText(requirementShot(project, test::onlyAsset(*asset), {Survives, DropRequirement{}}, nullptr)),
                 std::string("A drop needs the ground, which is off."));
    }
};

RUBBLE_TEST_WITH(RequirementShotTest, QCoreApplication)
#include "RequirementShotTest.moc"
