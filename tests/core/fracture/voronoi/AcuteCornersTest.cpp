#include "core/fracture/voronoi/AcuteCorners.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

namespace {

/// A triangle with a corner of 45 degrees at the origin.
const Polygon kTriangle{{{0, 0}, {4, 0}, {4, 4}}, {}};
constexpr LocalFrame kWeldFrame{.extent = 4.0, .weldDistance = 0.01};
// The edges are closer than sqrt(8) weld distances up to this distance from the corner, m: divided by the sine.
constexpr double kLength = 0.04;

}  // namespace

class AcuteCornersTest : public QObject {
    Q_OBJECT
private slots:
    void rightAnglesAreNotAcute() {
        const AcuteCorners corners(squareRing(), localFrame(squareRing()));
        QVERIFY(corners.isEmpty());
        for (std::uint32_t vertex = 0; vertex < 8; ++vertex) QVERIFY(!corners.isAcute(vertex));
    }
    void cornersBelowARightAngleAreAcute() {
        const AcuteCorners corners(kTriangle, kWeldFrame);
        QVERIFY(!corners.isEmpty());
        QVERIFY(corners.isAcute(0));
        QVERIFY(!corners.isAcute(1));  // 90 degrees
        QVERIFY(corners.isAcute(2));
    }
    void reflexTipsOfHolesAreNot() {  // the inside is around them, not between their edges
        const Polygon outline{rectangle({-9, -9}, {9, 9}), {{{0, 0}, {4, 4}, {4, 0}}}};
        const AcuteCorners corners(outline, kWeldFrame);
        QVERIFY(corners.isEmpty());
    }
    void regionIsTheTipBetweenTheEdges() {
        const AcuteCorners corners(kTriangle, kWeldFrame);
        QVERIFY(corners.contain(0, {0.9 * kLength, 0.3 * kLength}));
        QVERIFY(!corners.contain(0, {1.1 * kLength, 0.3 * kLength}));
        QVERIFY(corners.contain(0, {0.5 * kLength, -0.009}));  // beside an edge, by less than the weld distance
        QVERIFY(!corners.contain(0, {0.5 * kLength, -0.011}));
        QVERIFY(!corners.contain(1, {4.0, 0.0}));
        QVERIFY(corners.contain(2, {4.0 - 0.1 * kLength, 4.0 - 0.2 * kLength}));
    }
    void pointsAreRelativeToTheFrame() {
        LocalFrame moved = kWeldFrame;
        moved.origin = {4.0, 4.0};
        const AcuteCorners corners(kTriangle, moved);
        QVERIFY(corners.contain(2, {-0.1 * kLength, -0.2 * kLength}));
        QVERIFY(!corners.contain(2, {4.0 - 0.1 * kLength, 4.0 - 0.2 * kLength}));
    }
};

RUBBLE_TEST(AcuteCornersTest)
#include "AcuteCornersTest.moc"
