#include "core/geometry/polygon/IndexedCorners.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

class IndexedCornersTest : public QObject {
    Q_OBJECT
private slots:
    void edgesOfASquareStartAtTheLeft() {
        const std::vector<SweptEdge> edges = sweptEdges(indexedCorners(unitSquare()));
        QCOMPARE(edges.size(), std::size_t{4});
        QVERIFY(edges[0].left == Vec2(0.0, 0.0) && edges[0].right == Vec2(1.0, 0.0) && edges[0].runsRight);
        QVERIFY(edges[1].left == Vec2(1.0, 0.0) && edges[1].right == Vec2(1.0, 1.0) && edges[1].runsRight);
        QVERIFY(edges[2].left == Vec2(0.0, 1.0) && edges[2].right == Vec2(1.0, 1.0) && !edges[2].runsRight);
        QVERIFY(edges[3].left == Vec2(0.0, 0.0) && edges[3].right == Vec2(0.0, 1.0) && !edges[3].runsRight);
    }
    void edgesAreOrderedFromBottomToTop() {
        const SweptEdge low{{0.0, 0.0}, {2.0, 0.0}}, rising{{0.0, 0.0}, {2.0, 1.0}}, above{{1.0, 0.6}, {3.0, 0.6}};
        QVERIFY(isBelow(low, rising) && !isBelow(rising, low));      // from one point
        QVERIFY(isBelow(rising, above) && !isBelow(above, rising));  // which starts later
        QVERIFY(isBelow(low, above) && !isBelow(above, low));
    }
    void edgesThatTouchOnTheSweepLineAreEquivalent() {
        const SweptEdge edge{{0.0, 0.0}, {2.0, 1.0}}, fromItsMiddle{{1.0, 0.5}, {3.0, 5.0}};
        QVERIFY(!isBelow(edge, fromItsMiddle) && !isBelow(fromItsMiddle, edge));
        QVERIFY(!isBelow(edge, edge));
    }
};

RUBBLE_TEST(IndexedCornersTest)
#include "IndexedCornersTest.moc"
