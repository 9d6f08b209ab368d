#include "core/physics/step/NarrowPhase.h"

#include "core/physics/state/Contacts.h"
#include "core/physics/step/Displacement.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

/// A plate of 1 x 0.1 x 1 m that lies on a cube of 1 m at the origin, with a contact of both. Awake, without motion.
struct PlateOnCube {
    static constexpr std::uint32_t kCube = 1, kPlate = 2;
    WorldState state;
    std::uint32_t contact = kNone;

    PlateOnCube() {
        for (const Vec3 sides : {Vec3(1.0), Vec3(1.0, 0.1, 1.0)}) {
            const auto body = static_cast<std::uint32_t>(state.bodies.size());
            state.bodies.push_back({.shape = boxShape(sides), .kind = BodyKind::Dynamic, .isAwake = true});
            state.motions.emplace_back();
            state.poses.emplace_back().boundingRadius = state.bodies[body].shape->boundingRadius;
            state.predictions.emplace_back();
            state.obstacleSizes.push_back(kStands);
            state.proxies.push_back({.body = body});
        }
        state.poses[kPlate].centre = Vec3f(0.0f, 0.55f, 0.0f);
        state.bodies[kCube].friction = 0.4f;
        state.bodies[kPlate].friction = 0.9f;
        state.bodies[kCube].restitution = 0.2f;
        state.bodies[kPlate].restitution = 0.5f;
        state.colours.resizeBodies(state.bodies.size());
        contact = addContact(state, 0, 1);
    }
    HullCollision collide(float dt = 1.0f / 60.0f) const { return collideContact(state, state.contacts[contact], dt); }
    void store() {
        const HullCollision collision = collide();
        if (!state.contacts[contact].slot.isSet()) {
            beginTouching(state, contact, static_cast<std::uint32_t>(collision.manifold.count));
        }
        storeManifold(state, contact, collision);
    }
    ContactBlock& block() { return state.colours.block(state.contacts[contact].slot); }
    ReferenceBlock& reference() { return state.colours.reference(state.contacts[contact].slot); }
};

}  // namespace

class NarrowPhaseTest : public QObject {
    Q_OBJECT
private slots:
    /// A plate reaches 0.708 m from its centre and begins 0.05 m high: however fast it spins, no corner comes 0.66 m
    /// farther down. It rotates by 1.01 rad in the step, along tangents by 0.71 m.
    void whatSpinsHasContactsWithinItsReachOnly() {
        for (const auto& [gap, isReached] : {std::pair(0.6f, true), std::pair(0.7f, false)}) {
            PlateOnCube scene;
            scene.state.poses[PlateOnCube::kPlate].centre.y += gap;
            scene.state.motions[PlateOnCube::kPlate].angularVelocity = {60.5f, 0.0f, 0.0f};
            QCOMPARE(scene.collide().manifold.count > 0, isReached);
        }
    }
    void poseOfTheSecondInTheFirstsFrame() {
        BodyPose first, second;
        first.centre = Vec3f(1.0f, 0.0f, 0.0f);
        first.rotation = second.rotation = {0.0f, 0.0f, std::sqrt(0.5f), std::sqrt(0.5f)};  // x to y
        second.centre = Vec3f(1.0f, 2.0f, 0.0f);
        const RelativePose pose = relativePose(first, {}, second, {});
        QVERIFY(length(pose.offset - Vec3f(2.0f, 0.0f, 0.0f)) < 1e-6f);
        QVERIFY(length(pose.rotation.x - Vec3f(1.0f, 0.0f, 0.0f)) < 1e-6f);
        const RelativePose ofHulls = relativePose(first, Vec3f(0.0f, 0.0f, 1.0f), second, Vec3f(3.0f, 0.0f, 0.0f));
        QVERIFY(length(ofHulls.offset - Vec3f(5.0f, 0.0f, -1.0f)) < 1e-6f);
    }
    void storedManifoldHasTheMaterialOfThePair() {
        PlateOnCube pair;
        pair.store();
        QCOMPARE(pair.block().pointCount[0], 4u);
        QVERIFY(std::abs(pair.block().friction[0] - 0.6f) < 1e-6f);     // the geometric mean
        QCOMPARE(pair.block().restitution[0], 0.5f);                    // the larger
        QVERIFY(std::abs(pair.block().stiffening[0] - 50.0f) < 1e-3f);  // from a fifth of the thinner width: 20 mm
        QVERIFY(pair.block().normal.at(0) == Vec3f(0.0f, 1.0f, 0.0f));
        QVERIFY(std::abs(dot(pair.block().tangent.at(0), pair.block().normal.at(0))) < 1e-6f);
        QVERIFY(pair.reference().centreOffset.at(0) == Vec3f(0.0f, -0.55f, 0.0f));
        QCOMPARE(pair.reference().slack[0], 0.02f);
        QCOMPARE(pair.reference().isSwept[0], 0.0f);
    }
    /// The plate moves by 10 mm: the points are those of the same features.
    void pointsKeepTheirImpulses() {
        PlateOnCube pair;
        pair.store();
        for (std::size_t i = 0; i < 4; ++i) pair.block().points[i].impulse[0] = static_cast<float>(i + 1);
        const std::array<std::uint32_t, 4> features = pair.state.contacts[pair.contact].features;
        pair.state.poses[PlateOnCube::kPlate].centre.x = 0.01f;
        pair.store();
        int kept = 0;
        for (std::size_t i = 0; i < 4; ++i) {
            for (std::size_t j = 0; j < 4; ++j) {
                if (pair.state.contacts[pair.contact].features[i] != features[j]) continue;
                QCOMPARE(pair.block().points[i].impulse[0], static_cast<float>(j + 1));
                ++kept;
            }
        }
        QVERIFY(kept >= 2);
    }
    /// Both bodies rotate by 0.01 rad: friction is as before, in the world.
    void frictionIsThatOfTheNewTangents() {
        PlateOnCube pair;
        pair.store();
        const Vec3f t = pair.block().tangent.at(0), n = pair.block().normal.at(0);
        pair.block().frictionX[0] = 3.0f;
        pair.block().frictionY[0] = 4.0f;
        const Vec3f before = t * 3.0f + cross(n, t) * 4.0f;
        const Quatf small{0.005f, 0.0f, 0.0f, 1.0f};
        for (const std::uint32_t body : {PlateOnCube::kCube, PlateOnCube::kPlate}) {
            BodyPose& pose = pair.state.poses[body];
            pose.rotation = small.normalized();
            pose.centre = small.normalized().matrix() * pose.centre;
        }
        pair.store();
        const Vec3f t2 = pair.block().tangent.at(0), n2 = pair.block().normal.at(0);
        const Vec3f after = t2 * pair.block().frictionX[0] + cross(n2, t2) * pair.block().frictionY[0];
        QVERIFY(length(after - before) < 0.06f);  // 5 N·s by 0.01 rad
    }
    /// Apart by 0.4 m, they are collided again once they may have come 0.38 m closer along the axis that separates
    /// them: by moving, or by rotation.
    void gapsAreWatched() {
        PlateOnCube pair;
        WorldState& state = pair.state;
        state.poses[PlateOnCube::kPlate].centre.y = 0.95f;
        state.poses[PlateOnCube::kPlate].arc = 5.0f;
        const HullCollision collision = pair.collide();
        QCOMPARE(collision.manifold.count, 0);
        storeGap(state, pair.contact, collision);
        const SeparatedContact& gap = state.separated[0];
        QVERIFY(std::abs(std::abs(gap.gapNormal.y) - 1.0f) < 1e-6f);
        const auto isCollided = [&](Vec3f moved, float arc) {
            BodyMotion& motion = state.motions[PlateOnCube::kPlate];
            motion.deltaPosition = moved;
            const float radius = state.poses[PlateOnCube::kPlate].boundingRadius;
            motion.deltaRotation = Quatf{0.5f * arc / radius, 0.0f, 0.0f, 1.0f};
            return mayHaveTouched(state, gap);
        };
        QVERIFY(!isCollided({0.0f, -0.375f, 0.0f}, 0.0f));
        QVERIFY(isCollided({0.0f, -0.385f, 0.0f}, 0.0f));
        QVERIFY(!isCollided({0.0f, -0.175f, 0.0f}, 0.2f));
        QVERIFY(isCollided({0.0f, -0.185f, 0.0f}, 0.2f));
        QVERIFY(!isCollided({9.0f, 0.5f, 0.0f}, 0.2f));  // past it, and away
    }
    /// The plate falls 0.5 m in the step, five times its width: the manifold is that of the impact, 0.4 m below.
    void fastBodiesGetTheManifoldOfTheirImpact() {
        PlateOnCube pair;
        pair.state.poses[PlateOnCube::kPlate].centre.y = 0.95f;
        pair.state.motions[PlateOnCube::kPlate].velocity.y = -30.0f;
        const HullCollision collision = pair.collide();
        QVERIFY(collision.isSwept);
        QCOMPARE(collision.manifold.count, 4);
        QVERIFY(length(collision.offset - Vec3f(0.0f, 0.55f, 0.0f)) < 1e-5f);
        pair.store();
        QCOMPARE(pair.reference().isSwept[0], 1.0f);
        QVERIFY(pair.reference().slack[0] < 0.0f);  // outdated in the next step
        QVERIFY(length(pair.reference().centreOffset.at(0) - Vec3f(0.0f, -0.55f, 0.0f)) < 1e-5f);
    }
    /// At 2 m/s, 33 mm in the step, the margin is that much wider: 50 mm are near, 60 mm are not.
    void marginGrowsWithTheDisplacement() {
        const auto countAt = [](float gap) {
            PlateOnCube pair;
            pair.state.poses[PlateOnCube::kPlate].centre.y = 0.55f + gap;
            pair.state.motions[PlateOnCube::kPlate].velocity.y = -2.0f;
            return pair.collide().manifold.count;
        };
        QCOMPARE(countAt(0.05f), 4);
        QCOMPARE(countAt(0.06f), 0);
    }
};

RUBBLE_TEST(NarrowPhaseTest)
#include "NarrowPhaseTest.moc"
