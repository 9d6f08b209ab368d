#include "core/fracture/verify/VerifyGap.h"

#include "core/fracture/fragments/Extrusion.h"
#include "core/fracture/voronoi/VoronoiPartition.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <algorithm>

using namespace rubble;

namespace {

/// The halves of the unit square.
Fragments halves(double gap) {
    return *extrudedFragments({unitSquare(), 1.0},
                              *voronoiPartition(unitSquare(), std::vector<Vec2>{{0.25, 0.5}, {0.75, 0.5}}), gap);
}

/// The fault of halves with a gap of 0.25 m, after a point of the shrunk pieces was moved.
QString faultAfterMoving(Vec2 from, Vec2 to) {
    Fragments pieces = halves(0.25);
    Partition shrunk = *pieces.extruded()->shrunk;
    const auto point = std::ranges::find(shrunk.points, from);
    if (point == shrunk.points.end()) return "There is no such point.";
    *point = to;
    pieces.extruded()->shrunk = std::make_shared<const Partition>(shrunk);
    return QString::fromStdString(verifyGap(pieces, 0.25).value_or(""));
}

}  // namespace

class VerifyGapTest : public QObject {
    Q_OBJECT
private slots:
    void piecesAreShrunkByTheirGap() {
        QVERIFY(!verifyGap(halves(0.0), 0.0));
        QVERIFY(!verifyGap(halves(0.25), 0.25));
        QCOMPARE(verifyGap(halves(0.0), 0.25).value_or(""), "The pieces are not shrunk as the gap requires.");
        QCOMPARE(verifyGap(halves(0.25), 0.0).value_or(""), "The pieces are not shrunk as the gap requires.");
    }
    void largerGapIsNotKept() {
        QCOMPARE(verifyGap(halves(0.25), 0.3).value_or(""), "Fragment 0 extends into the gap.");
    }
    void pointsStayOutOfTheGapAndInThePiece() {
        QCOMPARE(faultAfterMoving({0.0, 0.0}, {0.0, 0.0}), QString());
        QCOMPARE(faultAfterMoving({0.375, 0.0}, {0.4, 0.125}), QString("Fragment 0 extends into the gap."));
        QCOMPARE(faultAfterMoving({0.0, 0.0}, {-0.125, 0.5}), QString("Fragment 0 extends beyond its piece."));
        QCOMPARE(faultAfterMoving({1.0, 1.0}, {1.125, 0.5}), QString("Fragment 1 extends beyond its piece."));
    }
};

RUBBLE_TEST(VerifyGapTest)
#include "VerifyGapTest.moc"
