#include "tests/support/TestProgram.h"
#include "tests/support/asset/Simulated.h"
#include "tests/support/scenes/SceneParts.h"

#include <cmath>
#include <functional>

using namespace rubble;
using Hidden = std::function<bool(Vec3)>;

namespace {

constexpr double kImpulse = 2000.0;  // N·s/m² at the centre
constexpr double kRadius = 3.0;      // m
const Vec3 kPane{1.0, 1.0, 0.1};     // m

/// What a blast does to a box: sums over small parts of its faces, without those that are hidden.
struct BoxSum {
    Vec3 impulse{0.0};
    Vec3 moment{0.0};  // about the origin
};
BoxSum sumOnBox(
    Vec3 blast, Vec3 centre, Vec3 sides, const Hidden& isHidden = [](Vec3) { return false; }) {
    constexpr int kParts = 400;
    BoxSum sum;
    for (int face = 0; face < 6; ++face) {
        const int axis = face % 3, u = (axis + 1) % 3, v = (axis + 2) % 3;
        Vec3 normal(0.0);
        normal[axis] = face < 3 ? 1.0 : -1.0;
        const double area = sides[u] * sides[v] / (kParts * kParts);
        for (int k = 0; k < kParts * kParts; ++k) {
            Vec3 point = centre + 0.5 * sides * normal;
            point[u] += sides[u] * ((k % kParts + 0.5) / kParts - 0.5);
            point[v] += sides[v] * ((k / kParts + 0.5) / kParts - 0.5);
            const Vec3 way = point - blast;
            const double distance = glm::length(way), facing = -glm::dot(way, normal) / distance;
            if (facing <= 0.0 || distance > kRadius || isHidden(point)) continue;
            const Vec3 impulse = way / distance * (kImpulse * (1.0 - distance / kRadius) * facing * area);
            sum.impulse += impulse;
            sum.moment += glm::cross(point, impulse);
        }
    }
    return sum;
}

/// A pane about the origin in n x n boxes with gaps.
BodyScene paneOf(int n, double gap = 0.0) {
    BodyScene scene;
    scene.gravity = Vec3(0.0);
    const double side = 1.0 / n;
    const std::uint32_t shape = test::addShape(scene, {test::boxOf({side - gap, side - gap, kPane.z})});
    for (int k = 0; k < n * n; ++k) {
        const Vec3 position((k % n + 0.5) * side - 0.5, (k / n + 0.5) * side - 0.5, 0.0);
        test::addFreeBody(scene, "piece " + std::to_string(k), shape, {.position = position});
    }
    return scene;
}

/// The sum of the impulses on all bodies, or on one.
Vec3 totalOf(const World& world, Vec3 blast, BodyId body = {}) {
    Vec3 total(0.0);
    for (const BlastImpulse& one : world.blast(blast, kRadius, kImpulse)) {
        if (body.index == 0 || one.body == body) total += one.impulse;
    }
    return total;
}

bool isClose(Vec3 found, Vec3 expected, double part) {
    const bool is = glm::distance(found, expected) <= part * glm::length(expected);
    if (!is) {
        qWarning("(%g, %g, %g) instead of (%g, %g, %g)", found.x, found.y, found.z, expected.x, expected.y, expected.z);
    }
    return is;
}

void addBlasts() {
    QTest::addColumn<Vec3>("blast");
    QTest::newRow("1 cm off") << Vec3(0.0, 0.0, 0.06);
    QTest::newRow("5 cm off") << Vec3(0.1, 0.2, 0.1);
    QTest::newRow("half a metre") << Vec3(0.0, 0.0, 0.5);
    QTest::newRow("2 m") << Vec3(0.0, 0.0, 2.05);
    QTest::newRow("above") << Vec3(0.3, 1.2, 0.5);
    QTest::newRow("beside") << Vec3(-1.5, 0.2, 0.15);
    QTest::newRow("near the radius") << Vec3(0.0, 0.0, 2.95);
    QTest::newRow("at the radius") << Vec3(0.0, 0.0, 3.03);
}

}  // namespace
Q_DECLARE_METATYPE(rubble::Vec3)

class BlastTest : public QObject {
    Q_OBJECT
private slots:
    void impulseIsTheIntegralOverTheFaces_data() { addBlasts(); }
    void impulseIsTheIntegralOverTheFaces() {
        QFETCH(Vec3, blast);
        SceneWorld made = test::worldOf(paneOf(1));
        const BoxSum expected = sumOnBox(blast, Vec3(0.0), kPane);
        QVERIFY(isClose(totalOf(made.world, blast), expected.impulse, 2e-3));
        QVERIFY(made.world.explode(blast, kRadius, kImpulse));
        const BodyState state = made.world.state(made.bodies[0]);
        const double mass = 100.0;  // kg
        QVERIFY(isClose(state.velocity, expected.impulse / mass, 2e-3));
        const Vec3 inertia = mass / 12.0 * Vec3(1.01, 1.01, 2.0);
        const Vec3 spin = expected.moment / inertia;
        QVERIFY(glm::distance(state.angularVelocity, spin) < 2e-3 * glm::length(spin) + 1e-4);
        const double energy =
            0.5 * mass * glm::dot(state.velocity, state.velocity) + 0.5 * glm::dot(inertia, spin * spin);
        QVERIFY(std::abs(made.world.momenta().kinetic - energy) < 5e-3 * energy);
    }
    void fragmentsTogetherGetWhatTheWholeGets_data() { addBlasts(); }
    void fragmentsTogetherGetWhatTheWholeGets() {
        QFETCH(Vec3, blast);
        const Vec3 whole = totalOf(test::worldOf(paneOf(1)).world, blast);
        for (const int n : {2, 3, 6, 12, 24, 32}) {
            QVERIFY2(isClose(totalOf(test::worldOf(paneOf(n)).world, blast), whole, 5e-3),
                     qPrintable(QString::number(n)));
            if (blast.z < 0.1) continue;  // so near, it reaches deep into a gap of 1 mm
            QVERIFY2(isClose(totalOf(test::worldOf(paneOf(n, 1e-3)).world, blast), whole, 0.05), "gap of 1 mm");
        }
    }
    /// A wall of 0.5 x 0.3 m hides the middle of the pane.
    void wallsShadow() {
        const Vec3 blast(0.1, 0.0, 1.05), wall(0.5, 0.3, 0.1), at(0.0, 0.0, 0.55);
        const auto isHidden = [&](Vec3 point) {
            double begin = 0.0, end = 1.0;  // of the line of sight, within the wall
            for (int axis = 0; axis < 3; ++axis) {
                const double way = point[axis] - blast[axis], middle = at[axis] - blast[axis];
                const double half = std::copysign(wall[axis] / 2.0, way);
                begin = std::max(begin, (middle - half) / way);
                end = std::min(end, (middle + half) / way);
            }
            return begin < end;
        };
        const Vec3 expected = sumOnBox(blast, Vec3(0.0), kPane, isHidden).impulse;
        for (const int n : {1, 5, 24}) {
            BodyScene scene = paneOf(n);
            test::addFixedBox(scene, "wall", at - wall / 2.0, at + wall / 2.0);
            SceneWorld made = test::worldOf(scene);
            const Vec3 total = totalOf(made.world, blast) - totalOf(made.world, blast, made.bodies.back());
            QVERIFY(isClose(total, expected, 0.01));  // the sum's parts are 2.5 mm wide
        }
        BodyScene scene = paneOf(4);
        test::addFixedBox(scene, "wall", {-9.0, -9.0, 0.2}, {9.0, 9.0, 0.4});
        SceneWorld made = test::worldOf(scene);
        QCOMPARE(made.world.blast(blast, kRadius, kImpulse).size(), 1u);
    }
    void facesBetweenTouchingBodiesGetNothing() {
        BodyScene scene = paneOf(1);
        const std::uint32_t box = test::addShape(scene, {test::boxOf(Vec3(0.1))});
        test::addFreeBody(scene, "behind", box, {.position = {0.0, 0.0, -0.1}});
        test::addFreeBody(scene, "in line", box, {.position = {0.0, 0.55, 0.0}});
        SceneWorld made = test::worldOf(scene);
        const Vec3 blast(0.0, 0.0, 0.5);
        QCOMPARE(totalOf(made.world, blast, made.bodies[1]), Vec3(0.0));
        const Vec3 expected = sumOnBox(blast, {0.0, 0.55, 0.0}, Vec3(0.1)).impulse;
        const Vec3 front =
            sumOnBox(blast, {0.0, 0.55, 0.0}, Vec3(0.1), [](Vec3 point) { return point.z < 0.0499; }).impulse;
        QVERIFY(isClose(totalOf(made.world, blast, made.bodies[2]), front, 2e-3));
        QVERIFY(glm::length(expected) > 1.2 * glm::length(front));
    }
    /// As one hull, in two with a face between, and in two that overlap.
    void facesBetweenHullsOfABodyGetNothing() {
        const Vec3 blast(0.1, 0.3, 0.6);
        const Vec3 whole = totalOf(test::worldOf(paneOf(1)).world, blast);
        for (const double overlap : {0.0, 0.1}) {
            const Polytope half = test::boxOf({0.5 + overlap, 1.0, 0.1});
            const double away = 0.25 - overlap / 2.0;
            BodyScene scene;
            test::addFreeBody(
                scene, "pane",
                test::addShape(scene, {translated(half, {-away, 0.0, 0.0}), translated(half, {away, 0.0, 0.0})}), {});
            const Vec3 found = totalOf(test::worldOf(scene).world, blast);
            if (overlap == 0.0) QVERIFY(isClose(found, whole, 1e-3));
            QVERIFY(glm::length(found) >= 0.999 * glm::length(whole));
        }
    }
    void nothingBeyondTheRadius() {
        SceneWorld made = test::worldOf(paneOf(1));
        QVERIFY(made.world.blast({0.0, 0.0, kRadius + 0.06}, kRadius, kImpulse).empty());
        QCOMPARE(made.world.blast({0.0, 0.0, kRadius + 0.04}, kRadius, kImpulse).size(), 1u);
        QVERIFY(made.world.blast({0.0, 0.0, 0.5}, 0.0, kImpulse).empty());
        QVERIFY(made.world.explode({0.0, 0.0, 4.0}, kRadius, kImpulse));
        QCOMPARE(made.world.momenta().kinetic, 0.0);
    }
    void impulsesLeadAwayFromTheBlast() {
        const Vec3 blast(0.2, -0.1, 0.3);
        for (const BlastImpulse& one : test::worldOf(paneOf(8)).world.blast(blast, kRadius, kImpulse)) {
            const Vec3 way = one.point - blast;
            QVERIFY(glm::dot(way, one.impulse) > 0.0);
            QVERIFY(glm::length(glm::cross(way, one.impulse)) < 1e-9 * glm::length(one.impulse));
            QVERIFY(std::abs(one.point.z - 0.05) < 0.01);  // on the face
        }
    }
    void blastInABodyGoesOffBesideIt() {
        SceneWorld made = test::worldOf(paneOf(1));
        const World& world = made.world;
        QCOMPARE(world.blastOrigin({0.0, 0.0, 0.06}), Vec3(0.0, 0.0, 0.06));
        for (const double z : {0.0505, 0.05, 0.02}) {
            QVERIFY(glm::distance(world.blastOrigin({0.1, 0.2, z}), Vec3(0.1, 0.2, 0.15)) < 1e-6);
        }
        QVERIFY(made.world.explode({0.1, 0.2, 0.05}, kRadius, kImpulse));
        const Vec3 expected = sumOnBox({0.1, 0.2, 0.15}, Vec3(0.0), kPane).impulse;
        QVERIFY(isClose(world.momenta().linear, expected, 2e-3));
    }
    void blastInARotatedBodyGoesOffBesideIt() {
        BodyScene scene;
        const Quat rotation = glm::angleAxis(0.5, Vec3(0.0, 0.0, 1.0));
        test::addFreeBody(scene, "plank", test::addShape(scene, {test::boxOf({4.0, 0.4, 0.4})}),
                          {.position = {0.0, 0.0, 0.0}, .orientation = rotation});
        const SceneWorld made = test::worldOf(scene);
        const Vec3 inside = rotation * Vec3(1.8, 0.15, 0.0), outside = rotation * Vec3(1.8, 0.3, 0.0);
        QVERIFY(glm::distance(made.world.blastOrigin(inside), outside) < 1e-5);
    }
    void smallBlastsPushWhatIsNear() {
        const SceneWorld made = test::worldOf(paneOf(1));
        const Vec3 expected(0.0, 0.0, -1.0);
        const std::vector<BlastImpulse> impulses = made.world.blast({0.0, 0.0, 0.1}, 0.2, kImpulse);
        QCOMPARE(impulses.size(), std::size_t{1});
        QVERIFY(glm::distance(glm::normalize(impulses[0].impulse), expected) < 1e-6);
    }
    void blastAtTheCentrePushesAgainstGravity() {
        BodyScene scene;
        test::addFreeBody(scene, "cube", test::addShape(scene, {test::boxOf(Vec3(1.0))}), {});
        SceneWorld made = test::worldOf(scene);
        for (const Vec3 down : {Vec3(-5.0, 0.0, 0.0), Vec3(0.0, 0.0, 3.0), Vec3(0.0)}) {
            QVERIFY(made.world.setGravity(down));
            const Vec3 origin = made.world.blastOrigin(Vec3(0.0));
            const Vec3 expected = 0.6 * (down == Vec3(0.0) ? Vec3(0.0, -1.0, 0.0) : glm::normalize(down));
            QVERIFY(glm::distance(origin, expected) < 1e-6);
        }
    }
    void blastInAStackGoesOffBesideTheStack() {
        BodyScene scene;
        const std::uint32_t brick = test::addShape(scene, {test::boxOf({1.0, 0.2, 0.5})});
        for (int k = 0; k < 5; ++k) {
            test::addFreeBody(scene, "brick " + std::to_string(k), brick, {.position = {0.0, 0.2 * k, 0.0}});
        }
        const Vec3 origin = test::worldOf(scene).world.blastOrigin({0.0, 0.4, 0.1});
        QVERIFY(glm::distance(origin, Vec3(0.0, 0.4, 0.35)) < 1e-6);
    }
    void blastAmidABodyPushesItToAllSides() {
        BodyScene scene;
        std::vector<Polytope> frame;
        for (const double side : {-0.55, 0.55}) {
            frame.push_back(translated(test::boxOf({0.1, 1.2, 0.2}), {side, 0.0, 0.0}));
            frame.push_back(translated(test::boxOf({1.0, 0.1, 0.2}), {0.0, side, 0.0}));
        }
        test::addFreeBody(scene, "frame", test::addShape(scene, frame), {});
        QVERIFY(glm::length(totalOf(test::worldOf(scene).world, Vec3(0.0))) < 1e-3);
    }
    void worldsWithMoreThreadsGetTheSameBits() {
        std::vector<ContentHash> hashes;
        for (const int threads : {1, 2, 5}) {
            SceneWorld made = test::worldOf(paneOf(20, 1e-3), {.threads = threads});
            test::simulate(made.world, 0.1);
            QVERIFY(made.world.explode({0.2, 0.1, 0.4}, kRadius, kImpulse));
            const std::shared_ptr<const Snapshot> before = made.world.snapshot();
            for (int round = 0; round < 2; ++round) {
                made.world.restore(*before);
                QVERIFY(made.world.explode({-0.2, 0.1, 0.5}, kRadius, kImpulse));
                test::simulate(made.world, 0.1);
                hashes.push_back(made.world.hash());
            }
        }
        QCOMPARE(hashes, std::vector<ContentHash>(hashes.size(), hashes.front()));
    }
    void turnedAndMovedPanesGetTheSame() {
        Random random(3);
        const Vec3 blast(0.3, 0.2, 0.6);
        const Vec3 expected = totalOf(test::worldOf(paneOf(6)).world, blast);
        for (int round = 0; round < 20; ++round) {
            const Quat turn = test::randomRotation(random);
            const Vec3 away = test::randomIn(random, 50.0);
            BodyScene scene = paneOf(6);
            for (SceneBody& body : scene.bodies) body.pose = {turn * body.pose.position + away, turn};
            const Vec3 found = totalOf(test::worldOf(scene).world, turn * blast + away);
            QVERIFY(isClose(glm::conjugate(turn) * found, expected, 2e-3));
        }
    }
};

RUBBLE_TEST(BlastTest)
#include "BlastTest.moc"
