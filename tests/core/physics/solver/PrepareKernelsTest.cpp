#include "tests/support/TestProgram.h"
#include "tests/support/scenes/OneContact.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

OneContact prepared(OneContact contact, SimdWidth width = widestSimd()) {
    contact.prepare(kernelsOf(width));
    return contact;
}

}  // namespace

class PrepareKernelsTest : public QObject {
    Q_OBJECT
private slots:
    /// At 0.25 m beside the centre: 1/2 + 3 · 0.25² = 0.6875/kg; the other point feels 1/2 - 3 · 0.25² of it.
    void effectiveMassesAndCoupling() {
        for (const SimdWidth width : availableSimdWidths()) {
            const OneContact contact = prepared(OneContact(kTwoPoints), width);
            QVERIFY(isClose(contact.block.points[0].effectiveMass[0], 1.0f / 0.6875f));
            QVERIFY(isClose(contact.block.points[1].effectiveMass[0], 1.0f / 0.6875f));
            QCOMPARE(contact.block.points[2].effectiveMass[0], 0.0f);  // there is no such point
            QVERIFY(isClose(contact.block.coupling[couplingIndex(0, 1)][0], 0.3125f));
        }
    }
    void couplingsHaveTheOrderOfTheirIndex() {
        const OneContact contact =
            prepared(OneContact({{-0.5f, 0.0f, 0.0f}, {0.25f, 0.0f, 0.0f}, {0.5f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}}));
        constexpr std::array<float, 4> kX{-0.5f, 0.25f, 0.5f, 0.0f};
        for (int i = 0; i < 4; ++i) {
            for (int j = i + 1; j < 4; ++j) {
                QVERIFY(isClose(contact.block.coupling[couplingIndex(i, j)][0], 0.5f + 3.0f * kX[i] * kX[j]));
            }
        }
    }
    /// At the bottom the tangents have 1/2 + 3 · 0.5² = 1.25/kg; torsion has the moment of inertia.
    void frictionMasses() {
        const OneContact contact = prepared(OneContact(kTwoPoints));
        QVERIFY(isClose(contact.block.tangentMassXX[0], 0.8f));
        QVERIFY(isClose(contact.block.tangentMassYY[0], 0.8f));
        QVERIFY(isClose(contact.block.tangentMassXY[0], 0.0f));
        QVERIFY(isClose(contact.block.torsionalMass[0], 1.0f / 3.0f));
        QVERIFY(isClose(contact.block.points[0].lever[0], 0.25f));
        QVERIFY(isClose(contact.block.points[1].lever[0], 0.25f));
    }
    /// Friction acts where the load is: a point 30 mm apart has half the weight of one that touches, one at 40 mm none.
    void frictionCentreIsWeightedByTheGap() {
        const auto centreX = [](float gap) {
            OneContact contact(kTwoPoints);
            contact.reference.separation[1][0] = gap;
            return prepared(contact).block.frictionCentre.x[0];
        };
        QVERIFY(isClose(centreX(0.0f), 0.0f));
        QVERIFY(isClose(centreX(0.02f), 0.0f));
        QVERIFY(isClose(centreX(0.03f), -0.25f / 3.0f));  // (-0.25 + 0.5 · 0.25) / 1.5
        QVERIFY(isClose(centreX(0.04f), -0.25f));
    }
    void approachIsTheSpeedAlongTheNormal() {
        OneContact contact(kTwoPoints);
        contact.cube().velocity = Vec3f(5.0f, -2.0f, 0.0f);
        contact.cube().angularVelocity.z = 4.0f;  // lifts x = 0.25 by 1 m/s
        contact.stepImpulse(0) = 7.0f;
        contact = prepared(contact);
        QVERIFY(isClose(contact.approach(0), -3.0f));
        QVERIFY(isClose(contact.approach(1), -1.0f));
        QCOMPARE(contact.stepImpulse(0), 0.0f);
    }
    /// The separation of the manifold, plus what the bodies have moved apart since.
    void separationsFollowTheBodies() {
        OneContact contact(kTwoPoints);
        contact.reference.separation[0][0] = 0.001f;
        contact.poses[OneContact::kCube].centre = Vec3f(0.1f, 0.502f, 0.0f);
        contact = prepared(contact);
        QVERIFY(isClose(contact.separation(0), 0.003f));
        QVERIFY(isClose(contact.separation(1), 0.002f));
        QVERIFY(isClose(contact.block.centreOffset.x[0], -0.1f));
        QVERIFY(isClose(contact.block.centreOffset.y[0], -0.502f));
    }
    /// Impulses of a swept manifold act where the bodies will touch.
    void sweptManifoldsKeepTheirOffset() {
        OneContact contact(kTwoPoints);
        contact.poses[OneContact::kCube].centre.y = 3.0f;
        contact.reference.isSwept[0] = 1.0f;
        contact = prepared(contact);
        QCOMPARE(contact.block.centreOffset.y[0], -0.5f);
        QVERIFY(isClose(contact.separation(0), 2.5f));
    }
    void manifoldsAreStaleBeyondTheirSlack() {
        for (const SimdWidth width : availableSimdWidths()) {
            const auto isStale = [&](float x, float angle) {
                OneContact contact(kTwoPoints);
                contact.reference.slack[0] = 0.01f;
                contact.poses[OneContact::kCube].centre.x = x;
                contact.poses[OneContact::kCube].rotation = {0.0f, std::sin(angle / 2.0f), 0.0f,
                                                             std::cos(angle / 2.0f)};
                contact = prepared(contact, width);
                return kernelsOf(width).staleLanes(contact.block, contact.reference, contact.step);
            };
            QCOMPARE(isStale(0.0f, 0.0f), 0u);
            QCOMPARE(isStale(0.009f, 0.0f), 0u);
            QCOMPARE(isStale(0.011f, 0.0f), 1u);
            // By the angle a, the point moves 0.25 a and the bounding radius of 1 m counts as a.
            QCOMPARE(isStale(0.0f, 0.0075f), 0u);
            QCOMPARE(isStale(0.0f, 0.0085f), 1u);
        }
    }
    /// Both bodies rotated alike, far: nothing moved relative to each other, but the normal is that of ten degrees ago.
    void manifoldsAreStaleAfterARotationByTenDegrees() {
        const auto isStale = [](float degrees) {
            OneContact contact({{0.0f, 0.5f, 0.0f}});
            const float half = degrees * 3.14159265f / 360.0f;
            for (BodyPose& pose : contact.poses) pose.rotation = {0.0f, std::sin(half), 0.0f, std::cos(half)};
            contact = prepared(contact);
            return kernelsOf(widestSimd()).staleLanes(contact.block, contact.reference, contact.step);
        };
        QCOMPARE(isStale(9.9f), 0u);
        QCOMPARE(isStale(10.1f), 1u);
    }
    void lanesWithoutPointsAreNeverStale() {
        OneContact contact({});
        contact.poses[OneContact::kCube].centre.x = 5.0f;
        contact = prepared(contact);
        QCOMPARE(kernelsOf(widestSimd()).staleLanes(contact.block, contact.reference, contact.step), 0u);
    }
};

RUBBLE_TEST(PrepareKernelsTest)
#include "PrepareKernelsTest.moc"
