#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SceneParts.h"

#include <QTest>

#include <array>

using namespace rubble;

namespace {

constexpr double kHalfPane = 0.5;  // m

/// A pane of 1 x 1 m, 5 mm thick, and a 5 cm box flying at it at 200 m/s from a random point in front of it.
BodyScene shotAtPane(Random& random, BodyKind kind) {
    BodyScene scene;
    scene.gravity = Vec3(0.0);
    const std::uint32_t pane = test::addShape(scene, {test::boxOf({2.0 * kHalfPane, 2.0 * kHalfPane, 0.005})});
    const std::uint32_t box = test::addShape(scene, {test::boxOf({0.05, 0.05, 0.05})});
    scene.bodies.push_back({.name = "pane", .kind = kind, .density = 2500.0, .shape = pane});
    const Vec3 aim{random.between(-0.4, 0.4), random.between(-0.4, 0.4), 0.0};
    const Vec3 displacement = glm::normalize(Vec3{random.between(-1.0, 1.0), random.between(-1.0, 1.0), -1.0});
    const Vec3 angularVelocity{random.between(-20.0, 20.0), random.between(-20.0, 20.0), random.between(-20.0, 20.0)};
    scene.bodies.push_back({.name = "box",
                            .pose = {.position = aim - displacement * random.between(0.2, 4.0),
                                     .orientation = test::randomRotation(random)},
                            .velocity = 200.0 * displacement,
                            .angularVelocity = angularVelocity,
                            .shape = box});
    return scene;
}

/// The position of the box in the pane's frame.
Vec3 boxFromPane(const SceneWorld& moved) {
    const Pose pane = moved.world.state(moved.bodies[0]).pose;
    return glm::conjugate(pane.orientation) * (moved.world.state(moved.bodies[1]).pose.position - pane.position);
}

bool passesThrough(const BodyScene& scene, double dt, double seconds) {
    SceneWorld moved = test::worldOf(scene);
    Vec3 before = boxFromPane(moved);
    for (double time = 0.0; time < seconds; time += dt) {
        moved.world.step(dt);
        const Vec3 now = boxFromPane(moved);
        if (before.z > 0.0 && now.z <= 0.0) {
            const Vec3 crossing = before + (now - before) * (before.z / (before.z - now.z));
            return std::abs(crossing.x) < kHalfPane && std::abs(crossing.y) < kHalfPane;
        }
        before = now;
    }
    return false;
}

/// A fixed pane of 1 x 1 m, 5 mm thick, at a random pose, and a 5 cm box flying at its front at up to 300 m/s.
BodyScene shotAtTiltedPane(Random& random) {
    BodyScene scene = shotAtPane(random, BodyKind::Static);
    SceneBody &pane = scene.bodies[0], &box = scene.bodies[1];
    const Quat rotation = test::randomRotation(random);
    const Vec3 place{random.between(-3.0, 3.0), random.between(-3.0, 3.0), random.between(-3.0, 3.0)};
    box.velocity *= random.between(5.0, 300.0) / 200.0;
    for (SceneBody* body : {&pane, &box}) {
        body->pose = {.position = place + rotation * body->pose.position,
                      .orientation = rotation * body->pose.orientation};
        body->velocity = rotation * body->velocity;
    }
    return scene;
}

/// The first impact of a scene of two bodies in steps of dt.
Impact firstImpact(const BodyScene& scene, double dt) {
    SceneWorld moved = test::worldOf(scene);
    for (double time = 0.0; time < 3.0; time += dt) {
        moved.world.collide(dt);
        const std::vector<Impact> impacts = moved.world.impacts();
        if (!impacts.empty()) return impacts[0];
        moved.world.solve(dt);
    }
    return {};
}

/// A fixed wall with the face x = 0, and a box in front of it.
BodyScene boxAndWall(const Pose& pose, Vec3 velocity) {
    BodyScene scene;
    scene.gravity = Vec3(0.0);
    test::addFixedBox(scene, "wall", {0.0, -20.0, -20.0}, {1.0, 20.0, 20.0});
    const std::uint32_t box = test::addShape(scene, {test::boxOf({0.5, 0.5, 0.5})});
    scene.bodies.push_back({.name = "box", .pose = pose, .velocity = velocity, .shape = box});
    return scene;
}

/// A free block of 600 kg, and a box of 200 kg that flies at its front at 22 m/s.
BodyScene boxAtBlock(Random& random) {
    BodyScene scene;
    scene.gravity = Vec3(0.0);
    const std::uint32_t block = test::addShape(scene, {test::boxOf({1.0, 1.0, 0.5})});
    const std::uint32_t box = test::addShape(scene, {test::boxOf(Vec3(0.6))});
    scene.bodies.push_back({.name = "block", .density = 1200.0, .shape = block});
    const Vec3 aim{random.between(-0.4, 0.4), random.between(-0.4, 0.4), 0.25};
    const Vec3 direction = glm::normalize(Vec3{random.between(-0.6, 0.6), random.between(-0.6, 0.6), -1.0});
    scene.bodies.push_back(
        {.name = "box",
         .density = 926.0,
         .pose = {.position = aim - random.between(1.0, 2.0) * direction, .orientation = test::randomRotation(random)},
         .velocity = 22.0 * direction,
         .shape = box});
    return scene;
}

/// A box of 5 kg that flies at 10 m/s over a splinter of 2 g, which spins.
BodyScene boxAboveSplinter(Random& random) {
    BodyScene scene;
    scene.gravity = Vec3(0.0);
    const std::uint32_t box = test::addShape(scene, {test::boxOf({0.1, 0.1, 0.1})});
    const std::uint32_t splinter = test::addShape(scene, {test::boxOf({0.05, 0.006, 0.006})});
    scene.bodies.push_back({.name = "box", .density = 5000.0, .velocity = {0.0, 0.0, -10.0}, .shape = box});
    scene.bodies.push_back({.name = "splinter",
                            .pose = {.position = Vec3(0.0, 0.0, -0.15) + test::randomIn(random, 0.05),
                                     .orientation = test::randomRotation(random)},
                            .velocity = test::randomIn(random, 20.0),
                            .angularVelocity = test::randomIn(random, 300.0),
                            .shape = splinter});
    return scene;
}

/// A box standing on a corner, with its centre above it.
Quat onACorner() {
    const Vec3 diagonal = glm::normalize(Vec3(1.0)), up{0.0, 1.0, 0.0};
    const Vec3 half = glm::normalize(diagonal + up);
    const Vec3 axis = glm::cross(diagonal, half);
    return {glm::dot(diagonal, half), axis.x, axis.y, axis.z};
}

BodyScene cornerDrop() {
    BodyScene scene;
    test::addGround(scene, 10.0);
    const std::uint32_t box = test::addShape(scene, {test::boxOf({0.5, 0.5, 0.5})});
    test::addFreeBody(scene, "box", box, {.position = {0.0, 5.0, 0.0}, .orientation = onACorner()});
    return scene;
}

}  // namespace

Q_DECLARE_METATYPE(BodyKind)

class ContinuousCollisionTest : public QObject {
    Q_OBJECT
private slots:
    void fastBoxDoesNotTunnelThroughAPane_data() {
        QTest::addColumn<BodyKind>("kind");
        QTest::newRow("fixed") << BodyKind::Static;
        QTest::newRow("free") << BodyKind::Dynamic;
    }
    void fastBoxDoesNotTunnelThroughAPane() {
        QFETCH(BodyKind, kind);
        Random random(200);
        int passed = 0;
        for (int shot = 0; shot < 1000; ++shot) {
            if (!passesThrough(shotAtPane(random, kind), test::kStep, 0.2)) continue;
            ++passed;
            qWarning("shot %d", shot);
        }
        QCOMPARE(passed, 0);
    }
    /// The box was carried along: by up to 20 cm in a step, and with the energy of its weight.
    void splinterCarriesNothingHeavierAlong() {
        constexpr std::uint64_t kSeed = 31;
        Random random(kSeed);
        for (int round = 0; round < 3000; ++round) {
            SceneWorld moved = test::worldOf(boxAboveSplinter(random));
            moved.world.step(test::kStep);
            const Vec3 position = moved.world.state(moved.bodies[0]).pose.position;
            const Vec3 aside{position.x, position.y, 0.0};
            QVERIFY2(glm::length(aside) < 0.01 && position.z < 1e-6 && position.z > -10.2 * test::kStep,
                     qPrintable(QString("seed %1, round %2: (%3, %4, %5)")
                                    .arg(kSeed)
                                    .arg(round)
                                    .arg(position.x)
                                    .arg(position.y)
                                    .arg(position.z)));
        }
    }
    void noBoxPassesThroughAnyOfTenThousandFixedPanes() {
        constexpr std::uint64_t kSeed = 21;
        Random random(kSeed);
        int passed = 0;
        for (int shot = 0; shot < 10'000; ++shot) {
            const BodyScene scene = shotAtTiltedPane(random);
            const double rate = std::array{30.0, 60.0, 120.0, 240.0}[static_cast<std::size_t>(shot % 4)];
            const Vec3 way = scene.bodies[1].pose.position - scene.bodies[0].pose.position;
            const double flight = (glm::length(way) + 1.0) / glm::length(scene.bodies[1].velocity);
            if (!passesThrough(scene, 1.0 / rate, flight + 0.1)) continue;
            ++passed;
            qWarning("seed %d, shot %d", static_cast<int>(kSeed), shot);
        }
        QCOMPARE(passed, 0);
    }
    void impactsDoNotDependOnTheTimeStep_data() {
        QTest::addColumn<BodyScene>("scene");
        const Quat askew = glm::normalize(Quat(0.9, 0.2, 0.3, -0.1));
        QTest::newRow("face") << boxAndWall({.position = {-3.0, 0.0, 0.0}}, {12.0, 0.0, 0.0});
        QTest::newRow("edge") << boxAndWall({.position = {-3.0, 0.0, 0.0}, .orientation = askew}, {12.0, 0.0, 0.0});
        QTest::newRow("grazing") << boxAndWall({.position = {-1.0, 0.0, 0.0}}, {1.5, 10.0, 0.0});
        QTest::newRow("corner drop") << cornerDrop();
    }
    void impactsDoNotDependOnTheTimeStep() {
        QFETCH(BodyScene, scene);
        const double finest = firstImpact(scene, 1.0 / 240.0).impulse();
        QVERIFY(finest > 0.0);
        for (const double rate : {30.0, 60.0, 120.0}) {
            const double impulse = firstImpact(scene, 1.0 / rate).impulse();
            qInfo("%.0f Hz: %.3f N·s, %+.2f %%", rate, impulse, 100.0 * (impulse / finest - 1.0));
            QVERIFY(std::abs(impulse - finest) <= 0.05 * finest);
        }
    }
    /// A box that flies obliquely at a block, as at the door of the demo house: the gap that it has yet to cover was
    /// left out, so that it hit beside the place and the time of impact.
    void obliqueImpactsDoNotDependOnTheTimeStep() {
        constexpr std::uint64_t kSeed = 41;
        Random random(kSeed);
        int different = 0;
        for (int round = 0; round < 300; ++round) {
            const BodyScene scene = boxAtBlock(random);
            const double finest = firstImpact(scene, 1.0 / 480.0).impulse();
            QVERIFY(finest > 0.0);
            for (const double rate : {30.0, 60.0, 120.0, 240.0}) {
                const double impulse = firstImpact(scene, 1.0 / rate).impulse();
                if (std::abs(impulse - finest) <= 0.01 * finest) continue;
                ++different;
                qInfo("seed %d, round %d, %.0f Hz: %.1f N·s instead of %.1f", static_cast<int>(kSeed), round, rate,
                      impulse, finest);
            }
        }
        // Of 1200; there were 389. Where two corners meet the block at once, either may be the first.
        QVERIFY2(different <= 24, QByteArray::number(different));
    }
    void flatImpactAcrossAJointTouchesBothFaces() {
        // Faces meet flat, and so do edges with edges at the same time, up to rounding: the faces are what touches.
        BodyScene scene;
        scene.gravity = Vec3(0.0);
        const std::uint32_t block = test::addShape(scene, {test::boxOf({1.0, 1.0, 0.5})});
        const std::uint32_t box = test::addShape(scene, {test::boxOf(Vec3(0.5))});
        test::addFreeBody(scene, "lower", block, {.position = {0.0, 1.5, 2.75}});
        test::addFreeBody(scene, "upper", block, {.position = {0.0, 2.5, 2.75}});
        test::addFreeBody(scene, "box", box, {});
        Random random(7);
        for (int round = 0; round < 300; ++round) {
            scene.bodies[2].pose.position = {random.between(-0.3, 0.3), random.between(1.9, 2.1),
                                             random.between(3.3, 3.5)};
            scene.bodies[2].velocity = {0.0, random.between(-3.0, 3.0), -20.0};
            for (SceneBody& body : scene.bodies) {
                const auto turn = [&] { return random.between(-1e-4, 1e-4); };
                body.pose.orientation = glm::normalize(Quat{1.0, turn(), turn(), turn()});
            }
            SceneWorld moved = test::worldOf(scene);
            moved.world.collide(test::kStep);
            const std::vector<Impact> impacts = moved.world.impacts();
            if (impacts.empty()) continue;
            QCOMPARE(impacts.size(), 2u);
            const Vec3 at = scene.bodies[2].pose.position;
            const double gap = at.z - 0.25 - 3.0, height = at.y + gap / 20.0 * scene.bodies[2].velocity.y;
            const auto isAt = [](double y, double low, double high) { return std::abs(y - (low + high) / 2.0) < 0.01; };
            QVERIFY2(isAt(impacts[0].point.y, height - 0.25, 2.0), QByteArray::number(round));
            QVERIFY2(isAt(impacts[1].point.y, 2.0, height + 0.25), QByteArray::number(round));
        }
    }
    /// Not with its back: the plate moves farther in a step than it is thick.
    void plateHitsAWallWithItsFace() {
        for (const double side : {-1.0, 1.0}) {
            BodyScene scene;
            scene.gravity = Vec3(0.0);
            const double far = 2.0 * side;
            test::addFixedBox(scene, "wall", {std::min(0.0, far), -9.0, -9.0}, {std::max(0.0, far), 9.0, 9.0});
            const std::uint32_t plate = test::addShape(scene, {test::boxOf({0.05, 0.5, 0.5})});
            scene.bodies.push_back({.name = "plate",
                                    .pose = {.position = {-side, 0.0, 0.0}},
                                    .velocity = {12.0 * side, 0.0, 0.0},
                                    .shape = plate});
            const Impact impact = firstImpact(scene, test::kStep);
            QVERIFY2(std::abs(impact.point.x) < 12.0 * test::kStep, QByteArray::number(impact.point.x));
        }
    }
    /// The other foot is 3 cm behind and hits with the remaining speed.
    void onlyTheFirstOfTwoFeetHasAnImpact() {
        for (const double dt : {1.0 / 60.0, 1.0 / 240.0}) {
            BodyScene scene = boxAndWall({.position = {-1.0, 0.0, 0.0}}, {12.0, 0.0, 0.0});
            const Polytope foot = test::boxOf({0.2, 0.2, 0.2});
            scene.shapes[1] = {translated(foot, {0.0, -0.4, 0.0}), translated(foot, {-0.03, 0.4, 0.0})};
            SceneWorld moved = test::worldOf(scene);
            std::vector<Impact> impacts;
            while (impacts.empty() && moved.world.state(moved.bodies[1]).centre.x < 0.0) {
                moved.world.collide(dt);
                impacts = moved.world.impacts();
                moved.world.solve(dt);
            }
            QCOMPARE(impacts.size(), 1u);
            QVERIFY(impacts[0].point.y < -0.3 && impacts[0].point.y > -0.5);
        }
    }
    void flatImpactIsMassTimesSpeed() {
        const Impact impact = firstImpact(boxAndWall({.position = {-3.0, 0.0, 0.0}}, {12.0, 0.0, 0.0}), test::kStep);
        QVERIFY(std::abs(impact.approachSpeed - 12.0) < 1e-4);
        QVERIFY(std::abs(impact.effectiveMass - 125.0) < 1e-2);
        QVERIFY(std::abs(std::abs(impact.normal.x) - 1.0) < 1e-6);
        QVERIFY(std::abs(impact.point.y) < 1e-3 && std::abs(impact.point.z) < 1e-3);
    }
};

RUBBLE_TEST(ContinuousCollisionTest)
#include "ContinuousCollisionTest.moc"
