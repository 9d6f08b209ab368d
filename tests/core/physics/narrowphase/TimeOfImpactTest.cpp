#include "core/physics/narrowphase/TimeOfImpact.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Hulls.h"

#include <QTest>

using namespace rubble;
using namespace rubble::test;

namespace {

/// Two cubes of 1 m; the second, at `offset`, moves.
TimeOfImpact timeOfCubes(Vec3f offset, Vec3f displacement, const Mat3f& rotation = {}) {
    const Hull cube = hullOf(boxOf(Vec3(1.0)));
    return timeOfImpact(cube, cube, {rotation, offset}, displacement);
}

const float kHalfDiagonal = std::sqrt(0.5f);

}  // namespace

/// SeparatingAxisTest compares random hulls with small steps.
class TimeOfImpactTest : public QObject {
    Q_OBJECT
private slots:
    void facesTouchAfterTheGap() {
        const TimeOfImpact impact = timeOfCubes(Vec3f(0.2f, 3.0f, 0.0f), Vec3f(0.0f, -4.0f, 0.0f));
        QCOMPARE(impact.fraction, 0.5f);
        QVERIFY(impact.axis.isFace());
        QCOMPARE(impact.axis.separation, 0.0f);
        QVERIFY(impact.axis.normal == Vec3f(0.0f, 1.0f, 0.0f));
    }
    /// In x they overlap from 1/4, in y from 1/2 of the way: they touch along y.
    void lastAxisToOverlapCounts() {
        const TimeOfImpact impact = timeOfCubes(Vec3f(2.0f, 3.0f, 0.0f), Vec3f(-4.0f, -4.0f, 0.0f));
        QCOMPARE(impact.fraction, 0.5f);
        QVERIFY(impact.axis.normal == Vec3f(0.0f, 1.0f, 0.0f));
    }
    /// In x they overlap from 1/8 to 3/8 of the way, in y from 1/2.
    void cubesPassEachOther() {
        QVERIFY(timeOfCubes(Vec3f(2.0f, 3.0f, 0.0f), Vec3f(-8.0f, -4.0f, 0.0f)).axis.kind == AxisKind::None);
    }
    void cubesThatDoNotMeetInTime() {
        QVERIFY(timeOfCubes(Vec3f(0.0f, 3.0f, 0.0f), Vec3f(0.0f, -1.9f, 0.0f)).axis.kind == AxisKind::None);
        QVERIFY(timeOfCubes(Vec3f(0.0f, 3.0f, 0.0f), Vec3f(0.0f, 4.0f, 0.0f)).axis.kind == AxisKind::None);
        QVERIFY(timeOfCubes(Vec3f(0.0f, 3.0f, 0.0f), Vec3f(4.0f, 0.0f, 0.0f)).axis.kind == AxisKind::None);
    }
    void overlappingCubesHaveNone() {
        QVERIFY(timeOfCubes(Vec3f(0.5f, 0.5f, 0.5f), Vec3f(0.0f, -4.0f, 0.0f)).axis.kind == AxisKind::None);
    }
    /// A rotated cube falls from 2 m onto a floor of 200 km: it does not matter how the floor's normal is rounded.
    void largeFacesAreWhereTheyAre() {
        const Hull cube = hullOf(boxOf(Vec3(1.0))), floor = hullOf(boxOf(Vec3(2e5, 10.0, 2e5)));
        for (const double angle : {0.1, 0.7, 1.9}) {
            const Quat turned = glm::angleAxis(angle, glm::normalize(Vec3(0.3, 1.0, -0.4)));
            const Mat3 inverse = glm::transpose(glm::mat3_cast(turned));
            double lowest = 0.0;
            for (int k = 0; k < cube.cornerCount; ++k) lowest = std::min(lowest, (turned * toDouble(cube.corner(k))).y);
            const auto inCube = [&](Vec3 v) { return toFloat(inverse * v); };
            const Mat3f rotation(toFloat(inverse[0]), toFloat(inverse[1]), toFloat(inverse[2]));
            const Vec3 gap{0.0, lowest - 5.0 - 2.0, 0.0};
            const TimeOfImpact impact = timeOfImpact(cube, floor, {rotation, inCube(gap)}, inCube({0.0, 4.0, 0.0}));
            QVERIFY2(std::abs(impact.fraction - 0.5f) < 1e-5f, QByteArray::number(impact.fraction));
        }
    }
    /// An edge along z, in front, meets the side at x = 0.5.
    void edgeTouchesAFace() {
        const float s = kHalfDiagonal;
        const TimeOfImpact impact = timeOfCubes(Vec3f(3.0f, 0.1f, 0.0f), Vec3f(-4.0f, 0.0f, 0.0f),
                                                {Vec3f(s, s, 0.0f), Vec3f(-s, s, 0.0f), Vec3f(0.0f, 0.0f, 1.0f)});
        QVERIFY(std::abs(impact.fraction - (2.5f - s) / 4.0f) < 1e-5f);
        QVERIFY(impact.axis.kind == AxisKind::FirstFace);
        QVERIFY(length(impact.axis.normal - Vec3f(1.0f, 0.0f, 0.0f)) < 1e-5f);
    }
    /// A square prism lies with an edge along x on top; another comes down with an edge along z below.
    void crossedEdgesTouch() {
        const float s = kHalfDiagonal;
        const Hull first = hullOf(*convexHull(std::vector<Vec3>{
            {-1, s, 0}, {-1, -s, 0}, {-1, 0, s}, {-1, 0, -s}, {1, s, 0}, {1, -s, 0}, {1, 0, s}, {1, 0, -s}}));
        const Hull second = hullOf(*convexHull(std::vector<Vec3>{
            {s, 0, -1}, {-s, 0, -1}, {0, s, -1}, {0, -s, -1}, {s, 0, 1}, {-s, 0, 1}, {0, s, 1}, {0, -s, 1}}));
        const TimeOfImpact impact =
            timeOfImpact(first, second, {{}, Vec3f(0.1f, 3.0f, 0.1f)}, Vec3f(0.0f, -4.0f, 0.0f));
        QVERIFY(impact.axis.kind == AxisKind::Edges);
        QVERIFY(std::abs(impact.fraction - (3.0f - 2.0f * s) / 4.0f) < 1e-5f);
        QVERIFY(length(impact.axis.normal - Vec3f(0.0f, 1.0f, 0.0f)) < 1e-5f);
    }
};

RUBBLE_TEST(TimeOfImpactTest)
#include "TimeOfImpactTest.moc"
