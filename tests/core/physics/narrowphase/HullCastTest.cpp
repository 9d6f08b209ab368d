#include "core/physics/narrowphase/HullCast.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

/// Casts a cube of 1 m from the origin at another, at `offset`.
HullCastHit castCube(Vec3f offset, Vec3f displacement) {
    const Hull cube = hullOf(boxOf(Vec3(1.0)));
    return castHull(cube, cube, {{}, offset}, displacement);
}

}  // namespace

class HullCastTest : public QObject {
    Q_OBJECT
private slots:
    /// 2 m apart along x, moved by 4: the faces meet after half of the way, where they overlap by half a metre in y.
    void facesMeet() {
        const HullCastHit hit = castCube(Vec3f(3.0f, 0.5f, 0.0f), Vec3f(4.0f, 0.0f, 0.0f));
        QVERIFY(std::abs(hit.fraction - 0.5f) < 1e-6f);
        QVERIFY(length(hit.normal - Vec3f(-1.0f, 0.0f, 0.0f)) < 1e-6f);
        QVERIFY(length(hit.point - Vec3f(0.5f, 0.25f, 0.0f)) < 1e-5f);  // the middle of where they touch
    }
    void cubesThatMiss() {
        QVERIFY(castCube(Vec3f(3.0f, 1.5f, 0.0f), Vec3f(4.0f, 0.0f, 0.0f)).fraction > 1.0f);   // beside
        QVERIFY(castCube(Vec3f(3.0f, 0.0f, 0.0f), Vec3f(1.9f, 0.0f, 0.0f)).fraction > 1.0f);   // too short
        QVERIFY(castCube(Vec3f(3.0f, 0.0f, 0.0f), Vec3f(-4.0f, 0.0f, 0.0f)).fraction > 1.0f);  // away
    }
    void overlappingCubesTouchAtOnce() {
        const HullCastHit hit = castCube(Vec3f(0.9f, 0.0f, 0.0f), Vec3f(0.0f, 5.0f, 0.0f));
        QCOMPARE(hit.fraction, 0.0f);
        QVERIFY(length(hit.normal - Vec3f(-1.0f, 0.0f, 0.0f)) < 1e-6f);
    }
    /// A cube on its edge, rotated by 45 degrees, meets the face with that edge: half a diagonal before its centre.
    void edgeMeetsFace() {
        const Hull cube = hullOf(boxOf(Vec3(1.0)));
        const float s = std::sqrt(0.5f);
        const Mat3f rotation{Vec3f(s, s, 0.0f), Vec3f(-s, s, 0.0f), Vec3f(0.0f, 0.0f, 1.0f)};
        const HullCastHit hit = castHull(cube, cube, {rotation, Vec3f(3.0f, 0.0f, 0.0f)}, Vec3f(4.0f, 0.0f, 0.0f));
        QVERIFY(std::abs(hit.fraction - (2.5f - s) / 4.0f) < 1e-5f);
        QVERIFY(length(hit.point - Vec3f(0.5f, 0.0f, 0.0f)) < 1e-4f);
        QVERIFY(length(hit.normal - Vec3f(-1.0f, 0.0f, 0.0f)) < 1e-5f);
    }
};

RUBBLE_TEST(HullCastTest)
#include "HullCastTest.moc"
