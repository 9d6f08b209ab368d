#include "core/play/breaking/DebrisRemoval.h"

#include "core/play/state/SessionBodies.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"
#include "tests/support/play/Sessions.h"

using namespace rubble;

namespace {

/// A block that breaks into ten when it is reported to, over a ground.
Session brokenBlock(const Debris& debris, double height = 0.5) {
    Project project = test::floatingBlock(10);
    project.instances[0].pose.position.y = height;
    project.gravity = {0.0, -9.81, 0.0};
    project.debris = debris;
    Session session = test::sessionOf(project);
    test::addInput(session, BreakInput{session.bodies()[1].number});
    session.step();
    return session;
}

}  // namespace
Q_DECLARE_METATYPE(rubble::Debris)

class DebrisRemovalTest : public QObject {
    Q_OBJECT
private slots:
    void debrisStaysByDefault() {
        Session session = brokenBlock({});
        for (int step = 0; step < 600; ++step) session.step();
        QCOMPARE(test::countOf(session, PlayRole::Debris), 10u);
    }
    void debrisFadesOutAndIsRemoved() {
        Session session = brokenBlock({.lifetime = 1.0, .fade = 0.5});
        const auto fade = [&] { return session.fadeOf(session.bodies().back()); };
        while (session.stepsDone() < 30) session.step();
        QCOMPARE(fade(), 0.0);
        while (session.stepsDone() < 45) session.step();
        QVERIFY(std::abs(fade() - 0.5) < 1e-9);
        while (session.stepsDone() < 59) session.step();
        QCOMPARE(test::countOf(session, PlayRole::Debris), 10u);
        session.step();
        QCOMPARE(test::countOf(session, PlayRole::Debris), 0u);
        QCOMPARE(session.events().removed.size(), 10u);
    }
    void fadeLongerThanTheLifetimeStartsAtBirth() {
        Session session = brokenBlock({.lifetime = 1.0, .fade = 9.0});
        const double fade = session.fadeOf(session.bodies().back());
        QVERIFY2(fade < 0.05, QByteArray::number(fade));
    }
    void smallestDebrisIsRemovedFirst() {
        Session session = brokenBlock({.maxFragments = 4});
        QCOMPARE(test::countOf(session, PlayRole::Debris), 4u);
        double largestGone = 0.0, smallestLeft = 1e9;
        for (const PlayRemoval& removal : session.events().removed) {
            const PlayBody& body = removal.body;
            QVERIFY(removal.reason == RemovalReason::Budget);
            largestGone = std::max(largestGone, body.asset->solid(body.fragment).shape->mass.volume);
        }
        for (const PlayBody& body : session.bodies()) {
            if (body.role != PlayRole::Debris) continue;
            smallestLeft = std::min(smallestLeft, session.world().shape(body.body).mass.volume);
        }
        QVERIFY(largestGone <= smallestLeft);
    }
    void sleepingDebrisIsRemovedBeforeMoving() {
        Project project = test::floatingBlock(10);
        project.instances[0].pose.position.y = 0.5;
        project.gravity = {0.0, -9.81, 0.0};
        project.debris = {.maxFragments = 10};
        const Id pebbles = test::addAsset(project,
                                          {.name = "pebbles",
                                           .material = project.materials[0].id,
                                           .shape = Prism{{rectangle({-0.1, -0.1}, {0.1, 0.1}), {}}, 0.1}},
                                          {UniformScatter{.count = 3}});
        test::addInstance(project, pebbles, "pebbles", {.position = {0.0, 40.0, 0.0}});
        project.instances[1].isFixed = true;
        Session session = test::sessionOf(project);
        test::addInput(session, BreakInput{session.bodies()[1].number});
        while (session.stepsDone() < 300) session.step();  // all asleep
        test::addInput(session, BreakInput{session.bodies()[1].number});
        session.step();
        QCOMPARE(test::countOf(session, PlayRole::Debris), 10u);
        QCOMPARE(session.events().removed.size(), std::size_t{3});
        for (const PlayRemoval& removal : session.events().removed) {  // larger than those still falling
            QCOMPARE(session.nameOf(removal.body).substr(0, 6), std::string("block/"));
        }
    }
    void oldestOfEqualDebrisIsRemoved() {
        Project project = test::floatingBlock(2);
        project.debris = {.maxFragments = 3};
        test::addInstance(project, project.assets[0].id, "later", {.position = {5.0, 5.0, 0.0}});
        Session session = test::sessionOf(project);
        test::addInput(session, BreakInput{session.bodies()[1].number});
        session.step();
        QCOMPARE(session.events().removed.size(), std::size_t{0});
        test::addInput(session, BreakInput{session.bodies()[1].number});
        session.step();
        QCOMPARE(session.events().removed.size(), std::size_t{1});
        QCOMPARE(session.nameOf(session.events().removed[0].body).substr(0, 6), std::string("block/"));
        QCOMPARE(test::countOf(session, PlayRole::Debris), 3u);
    }
    void wholeBodiesAreNoDebris_data() {
        QTest::addColumn<Debris>("debris");
        QTest::newRow("lifetime") << Debris{.lifetime = 0.5, .fade = 0.2};
        QTest::newRow("number") << Debris{.maxFragments = 1};
        QTest::newRow("both") << Debris{.lifetime = 0.5, .fade = 0.0, .maxFragments = 1};
    }
    void wholeBodiesAreNoDebris() {
        QFETCH(Debris, debris);
        Project project = test::floatingBlock();
        project.debris = debris;
        Session session = test::sessionOf(project);
        double x = 3.0;
        for (const ProjectileKind kind :
             {ProjectileKind::Box, ProjectileKind::Ball, ProjectileKind::Plank, ProjectileKind::Asset}) {
            const Throw thrown{.kind = kind,
                               .asset = kind == ProjectileKind::Asset ? project.assets[0].id : 0,
                               .from = {x, 40.0, 0.0},
                               .to = {x, 41.0, 0.0},
                               .speed = 1.0};
            test::addInput(session, ShotInput{"thrown", thrown});
            x += 3.0;
        }
        while (session.stepsDone() < 120) session.step();
        QCOMPARE(test::countOf(session, PlayRole::Projectile), 4u);
        QCOMPARE(test::countOf(session, PlayRole::Instance), 1u);
        for (const PlayBody& body : session.bodies()) QCOMPARE(session.fadeOf(body), 0.0);
    }
    void fragmentsOfThrownAssetsAreDebris() {
        Project project = test::floatingBlock(4);
        project.debris = {.lifetime = 0.5, .fade = 0.0};
        Session session = test::sessionOf(project);
        const Throw thrown{.kind = ProjectileKind::Asset,
                           .asset = project.assets[0].id,
                           .from = {9.0, 5.0, 0.0},
                           .to = {9.0, 9.0, 0.0},
                           .speed = 1.0};
        test::addInput(session, ShotInput{"thrown", thrown});
        while (session.stepsDone() < 60) session.step();
        test::addInput(session, BreakInput{session.bodies().back().number});
        while (session.stepsDone() < 89) session.step();
        QCOMPARE(test::countOf(session, PlayRole::Debris), 4u);
        session.step();
        QCOMPARE(test::countOf(session, PlayRole::Debris), 0u);
    }
    void removedBodiesAreReportedByNumber() {
        Session session = brokenBlock({.maxFragments = 4});
        const auto number = [](const PlayRemoval& removal) { return removal.body.number; };
        QVERIFY(std::ranges::is_sorted(session.events().removed, {}, number));
        for (const PlayRemoval& one : session.events().removed) QVERIFY(session.body(number(one)) == nullptr);
    }
    /// The time of a piece runs from when it came, not from the start.
    void lifetimeStartsAtBirth() {
        Project project = test::floatingBlock(10);
        project.debris = {.lifetime = 1.0, .fade = 0.5};
        Session session = test::sessionOf(project);
        while (session.stepsDone() < 90) session.step();
        test::addInput(session, BreakInput{session.bodies()[1].number});
        while (session.stepsDone() < 149) session.step();
        QCOMPARE(test::countOf(session, PlayRole::Debris), 10u);
        session.step();
        QCOMPARE(test::countOf(session, PlayRole::Debris), 0u);
    }
    /// What has faded counts no more among those that are too many.
    void fadedDebrisIsNotCounted() {
        Session session = brokenBlock({.lifetime = 1.0, .maxFragments = 10});
        while (session.stepsDone() < 59) session.step();
        const Throw thrown{.size = Vec3(0.2), .mass = 10.0, .from = {0.0, 40.0, 0.0}, .to = {9.0, 41.0, 0.0}};
        test::addInput(session, ShotInput{"box", thrown});
        session.step();
        QCOMPARE(session.events().removed.size(), 10u);
        QCOMPARE(test::countOf(session, PlayRole::Projectile), 1u);
    }
    void farBodiesAreRemoved() {
        Session session = test::sessionOf(test::floatingBlock());
        const Throw thrown{
            .size = Vec3(0.2), .mass = 10.0, .from = {0.0, 9.0, 9.0}, .to = {9.0, 9.0, 9.0}, .speed = 500.0};
        test::addInput(session, ShotInput{"box", thrown});
        for (int step = 0; step < 200; ++step) session.step();
        QCOMPARE(test::countOf(session, PlayRole::Projectile), 1u);
        for (int step = 0; step < 100; ++step) session.step();  // 2 km after 4 s
        QCOMPARE(test::countOf(session, PlayRole::Projectile), 0u);
        QCOMPARE(test::countOf(session, PlayRole::Instance), 1u);
    }
    void workIsLinearInTheBodies_data() {
        QTest::addColumn<int>("bodies");
        QTest::addColumn<bool>("isFaded");
        for (const int bodies : {1000, 64000}) {
            QTest::addRow("%d faded", bodies) << bodies << true;
            QTest::addRow("%d too many", bodies) << bodies << false;
        }
    }
    void workIsLinearInTheBodies() {
        QFETCH(int, bodies);
        QFETCH(bool, isFaded);
        PlayScene scene;
        if (isFaded) scene.project.debris.lifetime = 1.0;
        if (!isFaded) scene.project.debris.maxFragments = 1;
        const SessionSettings settings;
        SessionState state;
        state.lowest = -100.0;
        World world;
        SessionParts parts{scene, settings, state, world};
        const std::array<Polytope, 1> box{test::boxOf({0.1, 0.1, 0.1})};
        const std::shared_ptr<const Shape> shape = *makeShape(box);
        for (int k = 0; k < bodies; ++k) {
            const Vec3 position(k % 256, 0.0, k / 256);
            if (!addBody(parts, {.shape = shape, .pose = {.position = position}}, {.role = PlayRole::Debris}))
                QFAIL("The body cannot be added.");
        }
        state.step = 1000;  // all have faded out, where they fade
        const auto count = static_cast<std::size_t>(bodies);
        const std::size_t visited = removeDebris(parts);
        QCOMPARE(state.bodies.size(), std::size_t{isFaded ? 0u : 1u});
        QCOMPARE(state.events.removed.size(), count - state.bodies.size());
        QCOMPARE(world.bodyCount(), state.bodies.size());
        QVERIFY2(visited >= count && visited <= 4 * count, qPrintable(QString::number(visited)));
    }
    void fallenBodiesAreRemoved() {
        Project project = test::floatingBlock();
        project.gravity = {0.0, -9.81, 0.0};
        project.ground.isOn = false;
        Session session = test::sessionOf(project);
        for (int step = 0; step < 600; ++step) session.step();
        QVERIFY(session.bodies().empty());
    }
    /// What stands of a bonded wall fades out no more than a whole one, but from when it comes free.
    void whatIsHeldIsNoDebris() {
        PlayBody body{.role = PlayRole::Debris, .isHeld = true};
        const Debris debris{.lifetime = 0.5, .fade = 0.2};
        QVERIFY(!body.isDebris());
        QCOMPARE(fadeOf(body, debris, 600, 1.0 / 60.0), 0.0);
        body.isHeld = false;
        QCOMPARE(fadeOf(body, debris, 600, 1.0 / 60.0), 1.0);
    }
};

RUBBLE_TEST(DebrisRemovalTest)
#include "DebrisRemovalTest.moc"
