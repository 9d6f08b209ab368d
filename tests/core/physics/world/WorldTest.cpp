// Tests core/physics/world/World.cpp and core/physics/world/Bodies.cpp.
#include "core/physics/world/World.h"

#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SceneParts.h"
#include "tests/support/scenes/Scenes.h"

#include <QTest>

#include <cmath>

using namespace rubble;

namespace {

/// A ground, and boxes of 1 m centred at these points.
BodyScene boxesAt(std::initializer_list<Vec3> places) {
    BodyScene scene;
    test::addGround(scene, 20.0);
    const std::uint32_t box = test::addShape(scene, {test::boxOf({1.0, 1.0, 1.0})});
    for (const Vec3& place : places) {
        test::addFreeBody(scene, std::to_string(scene.bodies.size()), box, {.position = place});
    }
    return scene;
}

double heightOf(const SceneWorld& moved, std::size_t body) {
    return moved.world.state(moved.bodies[body]).pose.position.y;
}

/// All results of a step, as text.
std::string toldBy(const StepEvents& events) {
    std::string text;
    const auto add = [&](char what, BodyId first, BodyId second) {
        text += what + std::to_string(first.index) + '-' + std::to_string(second.index) + ' ';
    };
    for (const ContactEvent& event : events.began) add('b', event.first, event.second);
    for (const ContactEvent& event : events.ended) add('e', event.first, event.second);
    for (const HitEvent& event : events.hits) {
        add('h', event.first, event.second);
        text += std::to_string(event.impulse) + ' ';
    }
    return text;
}

std::string toldInTwoSeconds(const WorldSettings& settings) {
    SceneWorld moved = test::worldOf(test::heapScene(200), settings);
    std::string text;
    for (int step = 0; step < 120; ++step) {
        moved.world.step(test::kStep);
        text += toldBy(moved.world.events()) + '\n';
    }
    return text;
}

}  // namespace

class WorldTest : public QObject {
    Q_OBJECT
private slots:
    void connectedBodiesAreOneIslandAwakeOrAsleep() {
        SceneWorld moved = test::worldOf(boxesAt({{0.0, 0.5, 0.0}, {0.0, 1.5, 0.0}, {5.0, 0.5, 0.0}}));
        for (const int steps : {10, 200}) {
            for (int k = 0; k < steps; ++k) moved.world.step(test::kStep);
            const std::vector<std::uint32_t> islands = moved.world.islands();
            const auto islandOf = [&](std::size_t body) { return islands[moved.bodies[body].index]; };
            QCOMPARE(islandOf(0), 0u);  // the ground
            QCOMPARE(islandOf(1), moved.bodies[1].index);
            QCOMPARE(islandOf(2), islandOf(1));
            QCOMPARE(islandOf(3), moved.bodies[3].index);
            QCOMPARE(moved.world.contactPoints().size(), std::size_t{12});
        }
        QVERIFY(moved.world.state(moved.bodies[2]).asleep);
    }
    void bodyIsInsideItsBox() {
        SceneWorld moved = test::worldOf(boxesAt({{0.0, 4.0, 0.0}}));
        for (int k = 0; k < 30; ++k) moved.world.step(test::kStep);
        const Box3 box = moved.world.box(moved.bodies[1]);
        const double height = heightOf(moved, 1);
        QVERIFY(box.min.y <= height - 0.49 && box.max.y >= height + 0.49);
        QVERIFY(box.min.x <= -0.5 && box.max.x >= 0.5 && box.diagonal() < 4.0);
    }
    void restoredWorldContinuesIdentically_data() {
        QTest::addColumn<bool>("sleeping");
        QTest::newRow("awake") << false;
        QTest::newRow("asleep in part") << true;
    }
    void restoredWorldContinuesIdentically() {
        QFETCH(bool, sleeping);
        SceneWorld moved = test::worldOf(test::heapScene(200), {.sleeping = sleeping});
        test::simulate(moved.world, 3.0);
        const std::shared_ptr<const Snapshot> snapshot = moved.world.snapshot();
        std::vector<std::string> first, second;
        for (int step = 0; step < 90; ++step) {
            moved.world.step(test::kStep);
            first.push_back(moved.world.hash().hex());
        }
        moved.world.restore(*snapshot);
        for (int step = 0; step < 90; ++step) {
            moved.world.step(test::kStep);
            second.push_back(moved.world.hash().hex());
        }
        QVERIFY(first == second);
    }
    void snapshotIsRestoredInAnotherWorld() {
        SceneWorld moved = test::worldOf(test::heapScene(64));
        test::simulate(moved.world, 2.0);
        World other({.threads = 2, .lanes = SimdWidth::Scalar});
        other.restore(*moved.world.snapshot());
        test::simulate(moved.world, 1.0);
        test::simulate(other, 1.0);
        QCOMPARE(other.hash().hex(), moved.world.hash().hex());
    }
    void eventsAreDeterministic() {
        const std::string expected = toldInTwoSeconds({});
        QVERIFY(expected.find('h') != std::string::npos);
        QVERIFY(toldInTwoSeconds({.threads = 3, .lanes = SimdWidth::Scalar}) == expected);
    }
    /// A box of 2 x 4 x 6 m and 48 t, of which every term is known.
    void momentaAreThoseOfTheMotion() {
        BodyScene scene;
        scene.gravity = {0.0, -10.0, 0.0};
        test::addFreeBody(scene, "box", test::addShape(scene, {test::boxOf({2.0, 4.0, 6.0})}),
                          {.position = {3.0, 5.0, 7.0}});
        scene.bodies[0].velocity = {1.0, 2.0, 4.0};
        scene.bodies[0].angularVelocity = {1.0, 0.5, 0.25};
        const Momenta momenta = test::worldOf(scene).world.momenta();
        const double mass = 48e3;
        const Vec3 inertia = mass / 12.0 * Vec3(16.0 + 36.0, 4.0 + 36.0, 4.0 + 16.0);
        const Vec3 own = inertia * Vec3(1.0, 0.5, 0.25), velocity(1.0, 2.0, 4.0);
        const auto isNear = [](Vec3 a, Vec3 b) { return glm::distance(a, b) < 1e-6 * glm::length(b); };
        QVERIFY(isNear(momenta.linear, mass * velocity));
        QVERIFY(isNear(momenta.angular, own + mass * Vec3(5.0 * 4.0 - 7.0 * 2.0, 7.0 - 3.0 * 4.0, 3.0 * 2.0 - 5.0)));
        const double kinetic = 0.5 * mass * 21.0 + 0.5 * glm::dot(Vec3(1.0, 0.5, 0.25), own);
        QVERIFY(std::abs(momenta.kinetic - kinetic) < 1e-6 * kinetic);
        QVERIFY(std::abs(momenta.potential - mass * 10.0 * 5.0) < 1.0);
    }
    /// A fall from 0.5 m ends at 3.1 m/s, up to the change within a step.
    void fallCausesContactAndHitEvents() {
        SceneWorld moved = test::worldOf(boxesAt({{0.0, 1.0, 0.0}}));
        std::vector<ContactEvent> began;
        std::vector<HitEvent> hits;
        for (int step = 0; step < 60; ++step) {
            moved.world.step(test::kStep);
            for (const ContactEvent& event : moved.world.events().began) began.push_back(event);
            for (const HitEvent& event : moved.world.events().hits) hits.push_back(event);
        }
        QCOMPARE(began.size(), std::size_t{1});
        QCOMPARE(began[0].first, moved.bodies[0]);
        QCOMPARE(began[0].second, moved.bodies[1]);
        QCOMPARE(hits.size(), std::size_t{1});
        QVERIFY(std::abs(hits[0].approachSpeed - 3.13) < 0.2);
        QVERIFY(std::abs(hits[0].impulse - 1000.0 * hits[0].approachSpeed) <
                400.0);  // gravity's push over the step too
        QVERIFY(hits[0].normal.y > 0.999);
        moved.world.removeBody(moved.bodies[1]);
        QCOMPARE(moved.world.events().ended.size(), std::size_t{1});
    }
    void flatBoxDroppedFlatEndsWhereItFell_data() {
        QTest::addColumn<Vec3>("size");
        QTest::newRow("cube") << Vec3(1.0);
        QTest::newRow("small cube") << Vec3(0.1);
        QTest::newRow("flat block") << Vec3(2.0, 0.5, 1.0);
        QTest::newRow("post") << Vec3(0.3, 3.0, 0.3);
        QTest::newRow("plate") << Vec3(4.0, 0.2, 3.0);
    }
    void flatBoxDroppedFlatEndsWhereItFell() {
        QFETCH(Vec3, size);
        constexpr double kMaxShift = 1e-3, kMaxRotation = 1e-3;  // m, rad: a post rests within the tolerance of contact
        for (const double height : {3.0, 20.0}) {
            for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
                BodyScene scene;
                test::addGround(scene, 20.0);
                const std::uint32_t box = test::addShape(scene, {test::boxOf(size)});
                test::addFreeBody(scene, "box", box, {.position = {0.0, height + size.y / 2.0, 0.0}});
                SceneWorld moved = test::worldOf(scene);
                test::simulate(moved.world, 5.0, 1.0 / rate);
                const Pose pose = moved.world.state(moved.bodies[1]).pose;
                const double shift = std::hypot(pose.position.x, pose.position.z);
                const double rotation = 2.0 * std::hypot(pose.orientation.x, pose.orientation.y, pose.orientation.z);
                qInfo("from %g m at %g Hz: %.4f mm, %.2g rad", height, rate, 1e3 * shift, rotation);
                QVERIFY(shift < kMaxShift);
                QVERIFY(rotation < kMaxRotation);
                QVERIFY(moved.world.state(moved.bodies[1]).asleep);
            }
        }
    }
    void bodiesCanBeReplacedBetweenCollideAndSolve() {
        SceneWorld moved = test::worldOf(boxesAt({{0.0, 0.5, 0.0}, {0.0, 1.5, 0.0}, {0.0, 2.5, 0.0}}));
        test::simulate(moved.world, 0.2);
        moved.world.collide(test::kStep);
        moved.world.removeBody(moved.bodies[2]);
        const auto half = test::boxShape({0.5, 1.0, 1.0});
        const Result<BodyId> left = moved.world.addBody({.shape = half, .pose = {.position = {-0.25, 1.5, 0.0}}});
        const Result<BodyId> right = moved.world.addBody({.shape = half, .pose = {.position = {0.25, 1.5, 0.0}}});
        QVERIFY(left && right);
        moved.world.addContact(*left, *right);
        moved.world.addContact(*left, moved.bodies[1]);
        moved.world.collide(test::kStep);
        moved.world.solve(test::kStep);
        QVERIFY(!moved.world.contains(moved.bodies[2]));
        test::simulate(moved.world, 3.0);
        QVERIFY(std::abs(moved.world.state(*left).pose.position.y - 1.5) < 0.01);
        QVERIFY(std::abs(moved.world.state(*right).pose.position.y - 1.5) < 0.01);
        QVERIFY(std::abs(heightOf(moved, 3) - 2.5) < 0.01);
    }
    void idsAreNeverReused() {
        World world;
        const BodyId first = *world.addBody({.shape = test::boxShape({1.0, 1.0, 1.0})});
        world.removeBody(first);
        const BodyId second = *world.addBody({.shape = test::boxShape({1.0, 1.0, 1.0})});
        QVERIFY(!world.contains(first) && world.contains(second));
        QVERIFY(first != second);
    }
    void rayHitsTheNearestFace() {
        SceneWorld moved = test::worldOf(boxesAt({{0.0, 0.5, 0.0}, {3.0, 0.5, 0.0}}));
        const std::optional<CastHit> hit = moved.world.castRay({-5.0, 0.6, 0.1}, {5.0, 0.6, 0.1});
        QVERIFY(hit);
        QCOMPARE(hit->body, moved.bodies[1]);
        QVERIFY(glm::distance(hit->point, Vec3(-0.5, 0.6, 0.1)) < 1e-5);
        QVERIFY(glm::distance(hit->normal, Vec3(-1.0, 0.0, 0.0)) < 1e-5);
        QVERIFY(std::abs(hit->fraction - 0.45) < 1e-6);
        QVERIFY(!moved.world.castRay({-5.0, 2.0, 0.0}, {5.0, 2.0, 0.0}));
        QCOMPARE(moved.world.castRay({0.2, 9.0, 0.2}, {0.2, -9.0, 0.2})->body, moved.bodies[1]);
    }
    void overlappingFindsOverlappedBodies() {
        SceneWorld moved = test::worldOf(boxesAt({{0.0, 0.5, 0.0}, {3.0, 0.5, 0.0}}));
        const Polytope box = test::boxOf({0.2, 0.2, 0.2});
        QCOMPARE(*moved.world.overlapping(box, {.position = {0.0, 0.5, 0.0}}), std::vector<BodyId>{moved.bodies[1]});
        QCOMPARE(*moved.world.overlapping(box, {.position = {1.5, 0.5, 0.0}}), std::vector<BodyId>{});
        QCOMPARE(*moved.world.overlapping(test::boxOf({9.0, 1.0, 1.0}), {.position = {0.0, 0.3, 0.0}}), moved.bodies);
        QVERIFY(!moved.world.overlapping(Polytope{}, {}));
    }
    void blastPushesBodiesApart() {
        SceneWorld moved = test::worldOf(boxesAt({{-1.0, 0.5, 0.0}, {1.0, 0.5, 0.0}, {9.0, 0.5, 0.0}}));
        test::simulate(moved.world, 2.0);
        QVERIFY(moved.world.explode({0.0, 0.5, 0.0}, 4.0, 2000.0));
        QVERIFY(moved.world.state(moved.bodies[1]).velocity.x < -0.5);
        QVERIFY(moved.world.state(moved.bodies[2]).velocity.x > 0.5);
        QVERIFY(moved.world.state(moved.bodies[3]).asleep);  // beyond the radius
    }
    void impulseChangesVelocityByItsMass() {
        BodyScene scene = boxesAt({{0.0, 5.0, 0.0}});
        scene.gravity = Vec3(0.0);
        SceneWorld moved = test::worldOf(scene);
        QVERIFY(moved.world.applyImpulse(moved.bodies[1], {500.0, 0.0, 0.0}, {0.0, 5.5, 0.0}));
        const BodyState state = moved.world.state(moved.bodies[1]);
        QVERIFY(glm::distance(state.velocity, Vec3(0.5, 0.0, 0.0)) < 1e-6);
        QVERIFY(glm::distance(state.angularVelocity, Vec3(0.0, 0.0, -1.5)) < 1e-5);  // 250 N·m·s over 1000/6 kg·m²
    }
    /// A spring with a damping ratio of 1/√2 passes its target by 4 %, and a quarter of a second later is there.
    void grabbedBodyHardlyPassesItsTarget() {
        BodyScene scene;
        scene.gravity = Vec3(0.0);
        test::addFreeBody(scene, "cube", test::addShape(scene, {test::boxOf(Vec3(1.0))}), {});
        SceneWorld moved = test::worldOf(scene);
        QVERIFY(moved.world.grab(moved.bodies[0], Vec3(0.0), 1e9));
        QVERIFY(moved.world.dragTo({1.0, 0.0, 0.0}));
        double farthest = 0.0;
        for (int step = 0; step < 60; ++step) {
            moved.world.step(test::kStep);
            farthest = std::max(farthest, moved.world.state(moved.bodies[0]).centre.x);
        }
        QVERIFY2(farthest > 1.01 && farthest < 1.1, qPrintable(QString::number(farthest)));
        QVERIFY(std::abs(moved.world.state(moved.bodies[0]).centre.x - 1.0) < 0.001);
    }
    void grabbedBodyFollowsTheTarget() {
        SceneWorld moved = test::worldOf(boxesAt({{0.0, 0.5, 0.0}}));
        QVERIFY(moved.world.grab(moved.bodies[1], {0.0, 1.0, 0.0}, 1e5));
        QVERIFY(moved.world.dragTo({2.0, 4.0, 0.0}));
        test::simulate(moved.world, 5.0);
        const BodyState held = moved.world.state(moved.bodies[1]);
        const Vec3 grabbed = held.pose.position + held.pose.orientation * Vec3(0.0, 0.5, 0.0);
        qInfo("%.3f m away", glm::distance(grabbed, Vec3(2.0, 4.0, 0.0)));
        QVERIFY(glm::distance(grabbed, Vec3(2.0, 4.0, 0.0)) < 0.1);
        moved.world.release();
        test::simulate(moved.world, 5.0);
        QVERIFY(heightOf(moved, 1) < 1.0);
    }
    void weakGrabDoesNotLift() {
        SceneWorld moved = test::worldOf(boxesAt({{0.0, 0.5, 0.0}}));
        QVERIFY(moved.world.grab(moved.bodies[1], {0.0, 1.0, 0.0}, 5000.0));  // it weighs 9810 N
        QVERIFY(moved.world.dragTo({0.0, 4.0, 0.0}));
        test::simulate(moved.world, 2.0);
        QVERIFY(heightOf(moved, 1) < 0.55);
    }
    void kinematicBodyCarriesOthers() {
        BodyScene scene = boxesAt({{0.0, 1.5, 0.0}, {0.0, 0.5, 0.0}});
        scene.bodies[2].kind = BodyKind::Kinematic;
        scene.bodies[2].velocity = {0.5, 0.0, 0.0};
        SceneWorld moved = test::worldOf(scene);
        test::simulate(moved.world, 4.0);
        QVERIFY(std::abs(moved.world.state(moved.bodies[2]).pose.position.x - 2.0) < 1e-4);
        // It slips until friction has given it the speed: v² / (2 g friction) = 21 mm.
        QVERIFY(std::abs(moved.world.state(moved.bodies[1]).pose.position.x - 1.979) < 0.005);
        QVERIFY(std::abs(heightOf(moved, 1) - 1.5) < 0.01);
    }
    void kinematicBodyPushesOthers() {
        BodyScene scene = boxesAt({{1.2, 0.5, 0.0}, {0.0, 0.52, 0.0}});
        scene.bodies[2].kind = BodyKind::Kinematic;
        SceneWorld moved = test::worldOf(scene);
        test::simulate(moved.world, 2.0);
        QVERIFY(moved.world.state(moved.bodies[1]).asleep);
        QVERIFY(moved.world.setVelocity(moved.bodies[2], {1.0, 0.0, 0.0}, {}));
        test::simulate(moved.world, 2.0);
        QVERIFY(std::abs(moved.world.state(moved.bodies[1]).pose.position.x - 3.0) < 0.05);
    }
    void bodyOnARemovedOneWakesAndFalls() {
        SceneWorld moved = test::worldOf(boxesAt({{0.0, 0.5, 0.0}, {0.0, 1.5, 0.0}, {0.0, 2.5, 0.0}}));
        test::simulate(moved.world, 3.0);
        QVERIFY(test::areAllAsleep(moved));
        moved.world.removeBody(moved.bodies[1]);
        test::simulate(moved.world, 3.0);
        QVERIFY(std::abs(heightOf(moved, 2) - 0.5) < 0.01);
        QVERIFY(std::abs(heightOf(moved, 3) - 1.5) < 0.01);
    }
    void hitBodyWakes() {
        SceneWorld moved = test::worldOf(boxesAt({{0.0, 0.5, 0.0}, {0.5, 9.0, 0.0}}));
        test::simulate(moved.world, 1.0);
        QVERIFY(moved.world.state(moved.bodies[1]).asleep);
        test::simulate(moved.world, 0.4);
        QVERIFY(!moved.world.state(moved.bodies[1]).asleep);
    }
};

RUBBLE_TEST(WorldTest)
#include "WorldTest.moc"
