// Tests core/play/breaking/DamageDone.cpp, core/play/breaking/BreakImpulse.cpp and core/play/breaking/MovingMass.cpp.
#include "core/play/breaking/DamageDone.h"

#include "core/play/breaking/BreakImpulse.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SceneParts.h"

#include <cmath>

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

/// A session without a project, of the bodies of a world.
struct BoxesInSession {
    explicit BoxesInSession(World& of) : world(of) {
        state.origins = {{.name = "box"}};
        for (const BodyId body : world.bodies())
            state.bodies.push_back({.number = static_cast<std::uint32_t>(world.tag(body)), .body = body});
    }

    World& world;
    PlayScene scene;
    SessionSettings settings;
    SessionState state = {};
    SessionParts parts{scene, settings, state, world};
};

/// The break of the second box by the first.
PendingBreak breakOfSecond(const SceneWorld& made, double threshold) {
    PendingBreak broken;
    broken.event.body.body = made.bodies[1];
    broken.event.threshold = threshold;
    broken.event.impactor = made.bodies[0];
    broken.event.point = {0.51, 0.0, 0.0};
    broken.event.normal = {1.0, 0.0, 0.0};
    broken.mass = movingMass(made.world, made.bodies[1]);
    return broken;
}

}  // namespace

class DamageDoneTest : public QObject {
    Q_OBJECT
private slots:
    void impactRuleUsesTheImpact() {
        SceneWorld made = boxesAboutToMeet();
        const std::vector<Impact> impacts = made.world.impacts();
        const std::vector<DamageDone> damage = damageOf(impacts, made.world, DamageRule::Impact);
        QCOMPARE(damage.size(), 2u);
        for (const DamageDone& one : damage) QVERIFY(std::abs(one.amount - 1.5 * 4.0 * 500.0) < 0.1);
    }
    void momentumRuleUsesTheLargerMomentum() {
        SceneWorld made = boxesAboutToMeet();
        const std::vector<DamageDone> damage = damageOf(made.world.impacts(), made.world, DamageRule::Momentum);
        QVERIFY(std::abs(damage[0].amount - 1500.0) < 0.1);  // its own 3000 (1 - 0.5), the other's 1000
        QVERIFY(std::abs(damage[1].amount - 3000.0) < 0.1);  // the other's 3000, its own 1000
    }
    void largestImpactCounts() {
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
    void firstOfEqualImpactsCounts() {
        SceneWorld made = boxesAboutToMeet();
        const std::vector<Impact> impacts(3, made.world.impacts()[0]);
        for (const DamageDone& one : damageOf(impacts, made.world, DamageRule::Impact)) QCOMPARE(one.impact, 0u);
    }
    void breakImpulseIsLimitedToTheStoppingImpulse() {
        for (const double threshold : {100.0, 1e6}) {
            SceneWorld made = boxesAboutToMeet();
            BoxesInSession boxes(made.world);
            PendingBreak broken = breakOfSecond(made, threshold);
            const double before = made.world.momenta().linear.x;
            applyBreakImpulses(boxes.parts, {&broken, 1});
            const EnergyAudit& audit = boxes.state.events.energy;
            QCOMPARE(audit.size(), 1u);
            QVERIFY(audit[0].after < audit[0].before);
            const double impulse = std::min(threshold, 4.0 * 500.0);
            QVERIFY(std::abs(made.world.state(made.bodies[0]).velocity.x - (3.0 - impulse / 1000.0)) < 1e-5);
            QVERIFY(std::abs(broken.mass.velocity.x - (-1.0 + impulse / 1000.0)) < 1e-5);
            const double after = 1000.0 * (made.world.state(made.bodies[0]).velocity.x + broken.mass.velocity.x);
            QVERIFY(std::abs(after - before) < 1e-2);
        }
    }
    /// What the world does not take is applied to neither body, also where they break each other.
    void lostBreakImpulseIsReported() {
        for (const bool doBothBreak : {false, true}) {
            SceneWorld made = boxesAboutToMeet();
            BoxesInSession boxes(made.world);
            std::vector<PendingBreak> breaks{breakOfSecond(made, 1e30)};
            breaks[0].mass.velocity.x = -1e30;
            if (doBothBreak) {
                breaks.push_back(breakOfSecond(made, 100.0));
                breaks[1].event.body.body = made.bodies[0];
                breaks[1].event.impactor = {};
                breaks[1].mass = movingMass(made.world, made.bodies[0]);
            }
            applyBreakImpulses(boxes.parts, breaks);
            QCOMPARE(breaks[0].mass.velocity.x, -1e30);
            QCOMPARE(made.world.state(made.bodies[0]).velocity.x, 3.0);
            if (doBothBreak) QCOMPARE(breaks[1].mass.velocity.x, 3.0);
            QVERIFY(boxes.state.events.energy.empty());
            QCOMPARE(boxes.state.events.diagnostics.size(), 1u);
            QCOMPARE(boxes.state.events.diagnostics[0].message,
                     "The hit that broke \"box\": An impulse must be finite and at most 1e+24 N·s along each axis.");
        }
    }
    void separatingBodiesExchangeNoBreakImpulse() {
        SceneWorld made = boxesAboutToMeet();
        const MovingMass first = movingMass(made.world, made.bodies[0]),
                         second = movingMass(made.world, made.bodies[1]);
        QCOMPARE(stoppingImpulse(first, second, {0.5, 0.0, 0.0}, {-1.0, 0.0, 0.0}, 0.0), 0.0);
    }
    /// A shape of 2 m³ with its centre at x = 1 m, turned by 90 degrees about z at y = 5 m.
    void restingMassIsThatOfItsShapeInPlace() {
        Shape shape;
        shape.mass = {.volume = 2.0, .centre = {1.0, 0.0, 0.0}};
        shape.inertia = Mat3(1.0);
        const double half = std::sqrt(0.5);
        const MovingMass mass = restingMass(shape, 3.0, {{0.0, 5.0, 0.0}, Quat{half, 0.0, 0.0, half}});
        QCOMPARE(mass.inverseMass, 1.0 / 6.0);
        QVERIFY(glm::distance(mass.centre, Vec3(0.0, 6.0, 0.0)) < 1e-12);
    }
    void velocitiesAreLimitedAlongTheirDirection() {
        QCOMPARE(limitedVelocity({3.0, 0.0, -4.0}), Vec3(3.0, 0.0, -4.0));
        const Vec3 limited = limitedVelocity({3.0 * kMaxSpeed, 0.0, -4.0 * kMaxSpeed});
        QVERIFY(glm::distance(limited, Vec3(0.6, 0.0, -0.8) * kMaxSpeed) < 1e-9 * kMaxSpeed);
    }
};

RUBBLE_TEST(DamageDoneTest)
#include "DamageDoneTest.moc"
