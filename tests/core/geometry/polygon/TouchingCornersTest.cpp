#include "core/geometry/polygon/TouchingCorners.h"

#include "core/base/Random.h"
#include "core/geometry/predicates/Predicates.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"
#include "tests/support/geometry/Polyomino.h"

#include <QTest>

#include <algorithm>

using namespace rubble;

namespace {

/// The loop of links through a corner.
std::vector<std::uint32_t> loopThrough(const IndexedCorners& corners, std::uint32_t first) {
    std::vector<std::uint32_t> loop{first};
    for (std::uint32_t at = corners.next[first]; at != first; at = corners.next[at]) loop.push_back(at);
    return loop;
}

}  // namespace

class TouchingCornersTest : public QObject {
    Q_OBJECT
private slots:
    void cornersAtDifferentPointsStay() {
        IndexedCorners corners = indexedCorners(squareRing());
        const IndexedCorners before = corners;
        QVERIFY(splitTouchingCorners(corners));
        QCOMPARE(corners.next, before.next);
        QCOMPARE(corners.previous, before.previous);
    }
    void ringThroughOnePointTwiceBecomesTwoLoops() {
        // Two unit squares, one above and to the right of the other, in one ring.
        IndexedCorners corners = indexedCorners({{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}, {}});
        QVERIFY(splitTouchingCorners(corners));
        QCOMPARE(loopThrough(corners, 0), (std::vector<std::uint32_t>{0, 1, 6, 7}));
        QCOMPARE(loopThrough(corners, 3), (std::vector<std::uint32_t>{3, 4, 5, 2}));
    }
    void holeThatTouchesTheOuterRingBecomesPartOfIt() {
        IndexedCorners corners =
            indexedCorners({{{0, 0}, {2, 0}, {2, 2}, {0, 2}, {0, 1}}, {{{0, 1}, {1, 1.5}, {1, 0.5}}}});
        QVERIFY(splitTouchingCorners(corners));
        QCOMPARE(loopThrough(corners, 0).size(), std::size_t{8});
    }
    void ringThatCrossesItselfAtACornerIsRejected() {
        IndexedCorners corners = indexedCorners({{{0, 0}, {1, 1}, {2, 2}, {2, 0}, {1, 1}, {0, 2}}, {}});
        QVERIFY(!splitTouchingCorners(corners));
    }
    void sectorsOfTouchingCellsAreConvex() {
        int touching = 0;
        for (std::uint64_t number = 1; number <= 300; ++number) {
            Random random(number);
            Polyomino cells(6, 6);
            for (int x = 0; x < 6; ++x)
                for (int y = 0; y < 6; ++y) cells.set(x, y, random.below(5) < 3);
            cells.set(3, 3, true);
            IndexedCorners corners = indexedCorners(cells.componentAt(3, 3));
            const IndexedCorners before = corners;
            QVERIFY2(splitTouchingCorners(corners), qPrintable(QString("random seed %1").arg(number)));
            for (std::uint32_t corner = 0; corner < corners.cornerCount(); ++corner) {
                const std::uint32_t next = corners.next[corner], previous = corners.previous[corner];
                const Vec2 point = corners.points[corner];
                QCOMPARE(corners.previous[next], corner);
                QCOMPARE(corners.points[next], before.points[before.next[corner]]);  // the edge is the same
                if (std::ranges::count(corners.points, point) == 1) continue;
                ++touching;
                QVERIFY2(orient2d(corners.points[previous], point, corners.points[next]) > 0,
                         qPrintable(QString("random seed %1").arg(number)));
            }
        }
        QVERIFY2(touching > 100, qPrintable(QString::number(touching)));
    }
};

RUBBLE_TEST(TouchingCornersTest)
#include "TouchingCornersTest.moc"
