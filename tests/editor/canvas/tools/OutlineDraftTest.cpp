#include "editor/canvas/tools/OutlineDraft.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <glm/geometric.hpp>

using namespace rubble;

namespace {

void addAt(OutlineDraft& draft, Vec2 point) {
    draft.movePen(point);
    draft.add();
}

}  // namespace

class OutlineDraftTest : public QObject {
    Q_OBJECT
private slots:
    void repeatedPointsAreIgnored() {
        OutlineDraft draft(DraftShape::Polygon);
        addAt(draft, {0.0, 0.0});
        addAt(draft, {0.0, 0.0});
        QCOMPARE(draft.points().size(), std::size_t{1});
        QVERIFY(draft.removeLast());
        QVERIFY(!draft.removeLast());
    }
    void threePointsCloseNearTheFirst() {
        OutlineDraft draft(DraftShape::Polygon);
        addAt(draft, {0.0, 0.0});
        addAt(draft, {1.0, 0.0});
        draft.movePen({0.05, 0.0});
        QVERIFY(!draft.closesAt(0.1));  // two points only
        addAt(draft, {1.0, 1.0});
        draft.movePen({0.05, 0.0});
        QVERIFY(draft.closesAt(0.1));
        QVERIFY(!draft.closesAt(0.01));
        QCOMPARE(draft.ring(), (Ring{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}}));
    }
    void rectangleHasTwoOppositeCorners() {
        OutlineDraft draft(DraftShape::Rectangle);
        addAt(draft, {0.0, 0.0});
        QVERIFY(!draft.isComplete());
        addAt(draft, {2.0, 1.0});
        QVERIFY(draft.isComplete());
        QCOMPARE(draft.ring(), rectangle({0.0, 0.0}, {2.0, 1.0}));
    }
    void circleHasItsCentreAndAPointOnIt() {
        OutlineDraft draft(DraftShape::Circle);
        addAt(draft, {1.0, 1.0});
        addAt(draft, {1.0, 3.0});
        QVERIFY(draft.isComplete());
        const Box2 box = boundsOf(draft.ring());
        QVERIFY(glm::distance(box.min, Vec2(-1.0, -1.0)) < 0.03 && glm::distance(box.max, Vec2(3.0, 3.0)) < 0.03);
    }
};

RUBBLE_TEST(OutlineDraftTest)
#include "OutlineDraftTest.moc"
