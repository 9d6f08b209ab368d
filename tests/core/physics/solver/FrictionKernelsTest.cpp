#include "core/base/math/Trigonometry.h"
#include "tests/support/TestProgram.h"
#include "tests/support/scenes/OneContact.h"

#include <QTest>

#include <numbers>

using namespace rubble;
using namespace rubble::test;

namespace {

/// The cube pressed to the ground by `load` N·s, sliding.
OneContact sliding(const SolverKernels& kernels, float load, Vec3f velocity) {
    OneContact contact({kUnderCentre});
    contact.cube().velocity = velocity;
    contact.impulse(0) = load;
    contact.prepare(kernels, 0.0f);
    return contact;
}

}  // namespace

/// Friction is applied by relax(), which leaves the normal impulses of a cube at rest as they are. At the bottom of the
/// cube the effective mass of each tangent is 1 / (1/2 + 3 · 0.5²) = 0.8 kg.
class FrictionKernelsTest : public QObject {
    Q_OBJECT
private slots:
    void slowSlidingIsStopped() {
        for (const SimdWidth width : availableSimdWidths()) {
            const SolverKernels& kernels = kernelsOf(width);
            OneContact contact = sliding(kernels, 4.0f, Vec3f(0.05f, 0.0f, 0.0f));
            contact.apply(kernels.relax);
            QVERIFY(isClose(contact.block.frictionX[0], -0.04f));  // -0.8 · 0.05
            QVERIFY(isClose(contact.cube().velocity.x, 0.05f - 0.02f));
            QVERIFY(isClose(contact.cube().angularVelocity.z, -0.06f));  // (0, -0.5, 0) x (-0.04, 0, 0), times 3
            // The bottom is at rest: 0.03 - 0.06 · 0.5.
        }
    }
    /// The friction cone: at most μ λ = 0.5 · 4 = 2 N·s against the sliding, along both tangents, x and -z.
    void fastSlidingIsSlowedByTheFrictionCone() {
        for (const SimdWidth width : availableSimdWidths()) {
            const SolverKernels& kernels = kernelsOf(width);
            OneContact contact = sliding(kernels, 4.0f, Vec3f(3.0f, 0.0f, -4.0f));
            contact.apply(kernels.relax);
            QVERIFY(isClose(contact.block.frictionX[0], -1.2f));
            QVERIFY(isClose(contact.block.frictionY[0], -1.6f));
            QVERIFY(isClose(contact.cube().velocity.x, 3.0f - 0.6f));
            QVERIFY(isClose(contact.cube().velocity.z, -4.0f + 0.8f));
        }
    }
    /// Of a body that is easier to tilt one way than the other, too: what is left of the slip is opposite to the
    /// friction impulse, whatever the directions of slip.
    void frictionAtItsLimitActsAgainstTheSlip() {
        for (const SimdWidth width : availableSimdWidths()) {
            const SolverKernels& kernels = kernelsOf(width);
            for (int direction = 0; direction < 16; ++direction) {
                const double angle = 2.0 * std::numbers::pi * direction / 16.0;
                const Vec3f velocity = toFloat(10.0 * Vec3(cosine(angle), 0.0, sine(angle)));
                OneContact contact({kUnderCentre});
                contact.poses[OneContact::kCube].inverseInertia = {9.0f, 1.0f, -1.5f, 3.0f, 0.5f, 1.0f};
                contact.cube().velocity = velocity;
                contact.impulse(0) = 4.0f;
                contact.prepare(kernels, 0.0f);
                contact.apply(kernels.relax);
                const Vec3f friction(contact.block.frictionX[0], 0.0f, -contact.block.frictionY[0]);
                const Vec3f slip =
                    contact.cube().velocity + cross(contact.cube().angularVelocity, Vec3f(0.0f, -0.5f, 0.0f));
                QVERIFY(isClose(length(friction), 0.5f * contact.impulse(0)));  // μ λ
                const float across = friction.x * slip.z - friction.z * slip.x;
                QVERIFY(std::abs(across) < 0.005f * length(friction) * length(slip));  // 0.3 degrees
                QVERIFY(friction.x * slip.x + friction.z * slip.z < 0.0f);
            }
        }
    }
    void frictionOfFormerSubStepsCounts() {
        const SolverKernels& kernels = kernelsOf(widestSimd());
        OneContact contact = sliding(kernels, 4.0f, Vec3f(0.05f, 0.0f, 0.0f));
        contact.block.frictionX[0] = -1.98f;
        contact.apply(kernels.relax);
        QVERIFY(isClose(contact.block.frictionX[0], -2.0f));  // not -2.02
        QVERIFY(isClose(contact.cube().velocity.x, 0.05f - 0.01f));
    }
    void withoutLoadThereIsNoFriction() {
        const SolverKernels& kernels = kernelsOf(widestSimd());
        OneContact contact = sliding(kernels, 0.0f, Vec3f(1.0f, 0.0f, 0.0f));
        contact.apply(kernels.relax);
        QCOMPARE(contact.block.frictionX[0], 0.0f);
        QCOMPARE(contact.cube().velocity.x, 1.0f);
    }
    /// Points 0.25 m from the friction centre limit torsion to μ Σ λ l = 0.5 · 2 · 0.25 λ. The effective
    /// inertia is 1/3 kg·m².
    void torsionalFrictionIsLimitedByTheLevers() {
        for (const SimdWidth width : availableSimdWidths()) {
            const SolverKernels& kernels = kernelsOf(width);
            const auto rotating = [&](float load) {
                OneContact contact(kTwoPoints);
                contact.cube().angularVelocity.y = 1.0f;
                contact.impulse(0) = contact.impulse(1) = load;
                contact.prepare(kernels, 0.0f);
                contact.apply(kernels.relax);
                return contact;
            };
            const OneContact held = rotating(2.0f);  // limit 0.5 N·m·s
            QVERIFY(isClose(held.block.torsionalImpulse[0], -1.0f / 3.0f));
            QVERIFY(isClose(held.motions[OneContact::kCube].angularVelocity.y, 0.0f));
            const OneContact slowed = rotating(0.2f);  // limit 0.05 N·m·s
            QVERIFY(isClose(slowed.block.torsionalImpulse[0], -0.05f));
            QVERIFY(isClose(slowed.motions[OneContact::kCube].angularVelocity.y, 0.85f));
        }
    }
    /// A drop of 1 m/s with 4 N·s of friction left from warm starting: after the impact, 0.5 · 2 N·s of it may stay.
    void impactsTrimTheFrictionOfWarmStarting() {
        for (const SimdWidth width : availableSimdWidths()) {
            const SolverKernels& kernels = kernelsOf(width);
            OneContact contact = sliding(kernels, 0.0f, Vec3f(0.0f, -1.0f, 0.0f));
            contact.block.frictionX[0] = -4.0f;
            contact.block.torsionalImpulse[0] = 4.0f;
            contact.apply(kernels.solve);
            QVERIFY(isClose(contact.block.frictionX[0], -1.0f));
            QVERIFY(isClose(contact.block.torsionalImpulse[0], 1.0f));
            QVERIFY(isClose(contact.cube().velocity.x, 1.5f));          // 3 N·s taken back
            QVERIFY(isClose(contact.cube().angularVelocity.y, -9.0f));  // 3 N·m·s taken back
        }
    }
};

RUBBLE_TEST(FrictionKernelsTest)
#include "FrictionKernelsTest.moc"
