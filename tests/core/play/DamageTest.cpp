#include "core/play/Damage.h"

#include "core/play/Breaks.h"
#include "core/play/Missile.h"
#include "tests/support/Simulated.h"
#include "tests/support/scenes/SceneParts.h"

using namespace rubble;

namespace {

/// Two boxes of 1 m, 1000 kg, about to meet along x, the first at 3 m/s with restitution 0.5, the second at -1 m/s.
SceneWorld boxesAboutToMeet() {
    BodyScene scene;
    scene.gravity = Vec3(0.0);
    const std::uint32_t box = test::addShape(scene, {test::boxOf(Vec3(1.0))});
    test::addFreeBody(scene, "first", box, {.position = {0.0, 0.0, 0.0}});
    test::addFreeBody(scene, "second", box, {.position = {1.02, 0.0, 0.0}});
    scene.bodies[0].velocity = {3.0, 0.0, 0.0};
    scene.bodies[0].restitution = 0.5;
    scene.bodies[1].velocity = {-1.0, 0.0, 0.0};
    SceneWorld made = test::worldOf(scene);
    made.world.collide(test::kStep);
    return made;
}

}  // namespace

class DamageTest : public QObject {
    Q_OBJECT
private slots:
    void theImpactRuleTakesTheImpact() {
        SceneWorld made = boxesAboutToMeet();
        const std::vector<Impact> impacts = made.world.impacts();
        const std::vector<DamageDone> damage = damageOf(impacts, made.world, DamageRule::Impact);
        QCOMPARE(damage.size(), 2u);
        for (const DamageDone& one : damage) QVERIFY(std::abs(one.amount - 1.5 * 4.0 * 500.0) < 0.1);
    }
    void theMomentumRuleTakesTheLargerMomentum() {
        SceneWorld made = boxesAboutToMeet();
        const std::vector<DamageDone> damage = damageOf(made.world.impacts(), made.world, DamageRule::Momentum);
        QVERIFY(std::abs(damage[0].amount - 1500.0) < 0.1);  // its own 3000 (1 - 0.5), the other's 1000
        QVERIFY(std::abs(damage[1].amount - 3000.0) < 0.1);  // the other's 3000, its own 1000
    }
    void theLargestOfManyCounts() {
        SceneWorld made = boxesAboutToMeet();
        Impact impact = made.world.impacts()[0];
        Impact weaker = impact, stronger = impact;
        weaker.approachSpeed = 1.0;
        stronger.approachSpeed = 9.0;
        const std::vector<Impact> impacts{weaker, stronger, impact};
        const std::vector<DamageDone> damage = damageOf(impacts, made.world, DamageRule::Impact);
        QCOMPARE(damage.size(), 2u);
        QCOMPARE(damage[0].impact, 1u);
    }
    void aStrikerPaysNoMoreThanStopsIt() {
        for (const double threshold : {100.0, 1e6}) {
            SceneWorld made = boxesAboutToMeet();
            PendingBreak broken;
            broken.told.body.body = made.bodies[1];
            broken.told.threshold = threshold;
            broken.told.striker = made.bodies[0];
            broken.told.point = {0.51, 0.0, 0.0};
            broken.told.normal = {1.0, 0.0, 0.0};
            broken.mass = movingMass(made.world, made.bodies[1]);
            const double before = made.world.momenta().linear.x;
            payForBreaks(made.world, {&broken, 1});
            const double paid = std::min(threshold, 4.0 * 500.0);
            QVERIFY(std::abs(made.world.state(made.bodies[0]).velocity.x - (3.0 - paid / 1000.0)) < 1e-5);
            QVERIFY(std::abs(broken.mass.velocity.x - (-1.0 + paid / 1000.0)) < 1e-5);
            const double after = 1000.0 * (made.world.state(made.bodies[0]).velocity.x + broken.mass.velocity.x);
            QVERIFY(std::abs(after - before) < 1e-2);
        }
    }
    void whatPartsPaysNothing() {
        SceneWorld made = boxesAboutToMeet();
        const MovingMass first = movingMass(made.world, made.bodies[0]),
                         second = movingMass(made.world, made.bodies[1]);
        QCOMPARE(stoppingImpulse(first, second, {0.5, 0.0, 0.0}, {-1.0, 0.0, 0.0}, 0.0), 0.0);
    }
    void missilesAreWhatTheShotSays_data() {
        QTest::addColumn<int>("kind");
        QTest::newRow("box") << static_cast<int>(ProjectileKind::Box);
        QTest::newRow("ball") << static_cast<int>(ProjectileKind::Ball);
        QTest::newRow("plank") << static_cast<int>(ProjectileKind::Plank);
    }
    void missilesAreWhatTheShotSays() {
        QFETCH(int, kind);
        for (const Vec3 way : {Vec3(0.0, 0.0, -1.0), Vec3(1.0, 2.0, 3.0), Vec3(0.0, 1.0, 0.0), Vec3(0.0, -1.0, 0.0)}) {
            const Throw thrown{.kind = static_cast<ProjectileKind>(kind),
                               .size = {0.4, 0.2, 1.0},
                               .mass = 7.0,
                               .from = {1.0, 2.0, 3.0},
                               .to = Vec3(1.0, 2.0, 3.0) + way,
                               .speed = 5.0};
            const Result<BodyDefinition> body = missile(thrown, nullptr, nullptr);
            QVERIFY(body.hasValue());
            QVERIFY(std::abs(body->density * body->shape->mass.volume - 7.0) < 1e-9);
            QVERIFY(glm::distance(body->velocity, 5.0 * way / glm::length(way)) < 1e-9);
            QVERIFY(glm::distance(body->pose.position, Vec3(1.0, 2.0, 3.0)) < 1e-9);
            const Vec3 forwards = body->pose.orientation * Vec3(0.0, 0.0, -1.0);
            QVERIFY(glm::distance(forwards, way / glm::length(way)) < 1e-9);
            QVERIFY(std::abs((body->pose.orientation * Vec3(1.0, 0.0, 0.0)).y) < 1e-9);
            QVERIFY(!verifyPolytope(missileHull(thrown)));
        }
    }
    void aMissileOfNoUseIsRefused() {
        for (const double mass : {1e-12, 1e20}) {
            const Result<BodyDefinition> body = missile({.mass = mass}, nullptr, nullptr);
            QVERIFY(!body);
            QCOMPARE(body.error().message, std::string("What is thrown is too light or too heavy to be simulated."));
        }
    }
};

QTEST_APPLESS_MAIN(DamageTest)
#include "DamageTest.moc"
