#include "tests/support/TestProgram.h"
#include "tests/support/scenes/OneContact.h"

#include <QTest>

#include <numbers>

using namespace rubble;
using namespace rubble::test;

namespace {

constexpr float kH = 1.0f / 256.0f;  // the sub-step of OneContact
constexpr std::array<std::uint32_t, 1> kOnlyCube{OneContact::kCube};

SolverStep stepOf(OneContact& contact) {
    contact.step.motions = contact.motions.data();
    contact.step.poses = contact.poses.data();
    return contact.step;
}

}  // namespace

class IntegrationKernelsTest : public QObject {
    Q_OBJECT
private slots:
    void gravityAcceleratesThenDampingSlows() {
        OneContact contact({});
        contact.cube().velocity = Vec3f(256.0f, 0.0f, 1.0f);
        contact.cube().angularVelocity = Vec3f(3.0f, 6.0f, -9.0f);
        contact.cube().linearDamping = 256.0f;   // 1 / (1 + h · damping) = 1/2
        contact.cube().angularDamping = 512.0f;  // 1/3
        contact.step.gravity = Vec3f(0.0f, -512.0f, 0.0f);
        kernelsOf(widestSimd()).integrateVelocities(kOnlyCube, stepOf(contact));
        QVERIFY(contact.cube().velocity == Vec3f(128.0f, -1.0f, 0.5f));
        QVERIFY(length(contact.cube().angularVelocity - Vec3f(1.0f, 2.0f, -3.0f)) < 1e-6f);
    }
    void gravityLeavesBodiesThatAreNotDynamic() {
        OneContact contact({});
        contact.cube().inverseMass = 0.0f;
        contact.cube().velocity.x = 1.0f;
        contact.cube().linearDamping = 1.0f;
        contact.step.gravity = Vec3f(0.0f, -10.0f, 0.0f);
        kernelsOf(widestSimd()).integrateVelocities(kOnlyCube, stepOf(contact));
        QVERIFY(contact.cube().velocity == Vec3f(1.0f, 0.0f, 0.0f));
    }
    void positionsFollowTheVelocity() {
        for (const SimdWidth width : availableSimdWidths()) {
            OneContact contact({});
            contact.cube().velocity = Vec3f(1.0f, -2.0f, 3.0f);
            contact.cube().deltaPosition = Vec3f(0.5f, 0.0f, 0.0f);
            contact.cube().angularDamping = 0.25f;  // lies in between, and stays
            kernelsOf(width).integratePositions(kOnlyCube, stepOf(contact));
            QVERIFY(contact.cube().deltaPosition == Vec3f(0.5f + kH, -2.0f * kH, 3.0f * kH));
            QCOMPARE(contact.cube().angularDamping, 0.25f);
        }
    }
    /// A quarter of a rotation about each axis in turn, in 1000 sub-steps, is one about the diagonal by 120 degrees.
    void rotationsAreComposed() {
        for (const SimdWidth width : availableSimdWidths()) {
            OneContact contact({});
            const float speed = static_cast<float>(std::numbers::pi) / 2.0f / (1000.0f * kH);
            for (const Vec3f axis : {Vec3f(1.0f, 0.0f, 0.0f), Vec3f(0.0f, 1.0f, 0.0f)}) {
                contact.cube().angularVelocity = axis * speed;
                for (int k = 0; k < 1000; ++k) kernelsOf(width).integratePositions(kOnlyCube, stepOf(contact));
            }
            // In world axes, x first: q = q_y q_x = (1, 1, -1, 1) / 2.
            const Quatf q = contact.cube().deltaRotation;
            QVERIFY(std::abs(q.x - 0.5f) < 1e-3f && std::abs(q.y - 0.5f) < 1e-3f);
            QVERIFY(std::abs(q.z + 0.5f) < 1e-3f && std::abs(q.w - 0.5f) < 1e-3f);
            QVERIFY(isClose(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w, 1.0f));
        }
    }
    /// Any number of bodies, not only multiples of the width; the others stay.
    void everyBodyIsMovedOnce() {
        for (const SimdWidth width : availableSimdWidths()) {
            for (std::uint32_t count = 0; count <= 11; ++count) {
                std::vector<BodyMotion> motions(13);
                std::vector<BodyPose> poses(13);
                std::vector<std::uint32_t> bodies;
                for (std::uint32_t body = 0; body < motions.size(); ++body) motions[body].velocity.x = 256.0f;
                for (std::uint32_t body = 1; body <= count; ++body) bodies.push_back(body);
                SolverStep step = OneContact({}).step;
                step.motions = motions.data();
                step.poses = poses.data();
                kernelsOf(width).integratePositions(bodies, step);
                for (std::uint32_t body = 0; body < motions.size(); ++body) {
                    QCOMPARE(motions[body].deltaPosition.x, body >= 1 && body <= count ? 1.0f : 0.0f);
                }
            }
        }
    }
};

RUBBLE_TEST(IntegrationKernelsTest)
#include "IntegrationKernelsTest.moc"
