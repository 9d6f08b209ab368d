#include "tests/support/TestProgram.h"
#include "tests/support/scenes/OneContact.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

/// The cube after a step in which it was stopped: it had approached at 4 m/s, and its points got 8 N·s together.
OneContact stopped(const SolverKernels& kernels, const std::vector<Vec3f>& points, float restitution) {
    OneContact contact(points);
    contact.block.restitution[0] = restitution;
    contact.prepare(kernels, 0.0f);
    for (std::size_t i = 0; i < points.size(); ++i) {
        contact.approach(i) = -4.0f;
        contact.impulse(i) = contact.stepImpulse(i) = 8.0f / static_cast<float>(points.size());
    }
    return contact;
}

}  // namespace

class RestitutionKernelsTest : public QObject {
    Q_OBJECT
private slots:
    /// Restitution 0.5: 4 m/s become 2, by another 2 kg · 2 m/s.
    void halfOfTheSpeedComesBack() {
        for (const SimdWidth width : availableSimdWidths()) {
            OneContact contact = stopped(kernelsOf(width), {kUnderCentre}, 0.5f);
            contact.apply(kernelsOf(width).restitute);
            QVERIFY(isClose(contact.cube().velocity.y, 2.0f));
            QVERIFY(isClose(contact.impulse(0), 12.0f));
            QVERIFY(isClose(contact.stepImpulse(0), 12.0f));
        }
    }
    void boxThatLandsFlatDoesNotRotate() {
        for (const SimdWidth width : availableSimdWidths()) {
            OneContact contact = stopped(kernelsOf(width), kFourCorners, 1.0f);
            contact.apply(kernelsOf(width).restitute);
            QVERIFY(isClose(contact.cube().velocity.y, 4.0f));
            QVERIFY(length(contact.cube().angularVelocity) < 1e-5f);
        }
    }
    void withoutRestitutionNothingHappens() {
        OneContact contact = stopped(kernelsOf(widestSimd()), {kUnderCentre}, 0.0f);
        contact.apply(kernelsOf(widestSimd()).restitute);
        QCOMPARE(contact.cube().velocity.y, 0.0f);
        QCOMPARE(contact.impulse(0), 8.0f);
    }
    void slowApproachesDoNotRebound() {
        OneContact contact = stopped(kernelsOf(widestSimd()), {kUnderCentre}, 0.5f);
        contact.approach(0) = -0.99f;  // the restitution speed is 1 m/s
        contact.apply(kernelsOf(widestSimd()).restitute);
        QCOMPARE(contact.cube().velocity.y, 0.0f);
    }
    void pointsThatOnlyCameNearDoNotRebound() {
        OneContact contact = stopped(kernelsOf(widestSimd()), {kUnderCentre}, 0.5f);
        contact.stepImpulse(0) = 0.0f;
        contact.apply(kernelsOf(widestSimd()).restitute);
        QCOMPARE(contact.cube().velocity.y, 0.0f);
    }
    /// One corner was hit: it separates at 2 m/s, whatever the rest of the cube does.
    void cornerSeparatesAtItsSpeed() {
        OneContact contact = stopped(kernelsOf(widestSimd()), {{0.5f, 0.0f, 0.0f}}, 0.5f);
        contact.apply(kernelsOf(widestSimd()).restitute);
        const BodyMotion& cube = contact.cube();
        QVERIFY(isClose(cube.velocity.y + 0.5f * cube.angularVelocity.z, 2.0f));
        QVERIFY(cube.angularVelocity.z > 0.5f);
    }
    /// A point that separates faster already may lose its impulse, but is not pulled back by more.
    void restitutionDoesNotPull() {
        OneContact contact = stopped(kernelsOf(widestSimd()), {kUnderCentre}, 0.5f);
        contact.cube().velocity.y = 10.0f;
        contact.impulse(0) = 1.0f;
        contact.apply(kernelsOf(widestSimd()).restitute);
        QCOMPARE(contact.impulse(0), 0.0f);
        QVERIFY(isClose(contact.cube().velocity.y, 9.5f));
    }
};

RUBBLE_TEST(RestitutionKernelsTest)
#include "RestitutionKernelsTest.moc"
