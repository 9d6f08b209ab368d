#include "core/physics/narrowphase/HullRay.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

/// Rays at a box with sides of 2 m about the origin.
class HullRayTest : public QObject {
    Q_OBJECT
private slots:
    void rayEntersThroughAFace() {
        const HullRayHit hit = castRay(hullOf(boxOf(Vec3(2.0))), Vec3f(-3.0f, 0.5f, 0.0f), Vec3f(4.0f, 0.0f, 0.0f));
        QCOMPARE(hit.fraction, 0.5f);
        QVERIFY(hit.normal == Vec3f(-1.0f, 0.0f, 0.0f));
    }
    void slantedRayHitsTheFaceItMeetsLast() {
        // It passes the plane x = -1 after 1/4, outside, and y = 1 after 1/2.
        const HullRayHit hit = castRay(hullOf(boxOf(Vec3(2.0))), Vec3f(-2.0f, 3.0f, 0.0f), Vec3f(4.0f, -4.0f, 0.0f));
        QCOMPARE(hit.fraction, 0.5f);
        QVERIFY(hit.normal == Vec3f(0.0f, 1.0f, 0.0f));
    }
    void raysThatMissOrEndBefore() {
        const Hull box = hullOf(boxOf(Vec3(2.0)));
        QVERIFY(castRay(box, Vec3f(-3.0f, 0.0f, 0.0f), Vec3f(1.5f, 0.0f, 0.0f)).fraction > 1.0f);   // too short
        QVERIFY(castRay(box, Vec3f(-3.0f, 0.0f, 0.0f), Vec3f(-4.0f, 0.0f, 0.0f)).fraction > 1.0f);  // away
        QVERIFY(castRay(box, Vec3f(-3.0f, 1.5f, 0.0f), Vec3f(8.0f, 0.0f, 0.0f)).fraction > 1.0f);   // beside, parallel
        QVERIFY(castRay(box, Vec3f(-3.0f, 0.0f, 0.0f), Vec3f(4.0f, 4.0f, 0.0f)).fraction > 1.0f);   // beside, slanted
    }
    void rayOnAFaceGrazesIt() {
        QCOMPARE(castRay(hullOf(boxOf(Vec3(2.0))), Vec3f(-3.0f, 1.0f, 0.0f), Vec3f(4.0f, 0.0f, 0.0f)).fraction, 0.5f);
    }
    void rayThatEndsOnTheFaceHits() {
        QCOMPARE(castRay(hullOf(boxOf(Vec3(2.0))), Vec3f(-3.0f, 0.0f, 0.0f), Vec3f(2.0f, 0.0f, 0.0f)).fraction, 1.0f);
    }
    void raysFromInsideHitNothing() {
        QVERIFY(castRay(hullOf(boxOf(Vec3(2.0))), Vec3f(0.5f, 0.0f, 0.0f), Vec3f(4.0f, 0.0f, 0.0f)).fraction > 1.0f);
    }
    void rayFromTheFaceHitsAtOnce() {
        const HullRayHit hit = castRay(hullOf(boxOf(Vec3(2.0))), Vec3f(-1.0f, 0.0f, 0.0f), Vec3f(4.0f, 0.0f, 0.0f));
        QCOMPARE(hit.fraction, 0.0f);
        QVERIFY(hit.normal == Vec3f(-1.0f, 0.0f, 0.0f));
    }
};

RUBBLE_TEST(HullRayTest)
#include "HullRayTest.moc"
