#include "editor/canvas/tools/OutlineDraft.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

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
        OutlineDraft draft(std::nullopt);
        addAt(draft, {0.0, 0.0});
        addAt(draft, {0.0, 0.0});
        QCOMPARE(draft.points().size(), std::size_t{1});
        QVERIFY(draft.removeLast());
        QVERIFY(!draft.removeLast());
    }
    void threePointsCloseNearTheFirst() {
        OutlineDraft draft(std::nullopt);
        addAt(draft, {0.0, 0.0});
        addAt(draft, {1.0, 0.0});
        draft.movePen({0.05, 0.0});
        QVERIFY(!draft.closesAt(0.1));  // two points only
        addAt(draft, {1.0, 1.0});
        draft.movePen({0.05, 0.0});
        QVERIFY(draft.closesAt(0.1));
        QVERIFY(!draft.closesAt(0.01));
        QCOMPARE(draft.closed().outer, (Ring{{0.0, 0.0}, {1.0, 0.0}, {1.0, 1.0}}));
    }
    void draftInAContainerBecomesAHole() {
        OutlineDraft draft(unitSquare());
        for (const Vec2 point : {Vec2{0.2, 0.2}, Vec2{0.4, 0.2}, Vec2{0.4, 0.4}}) addAt(draft, point);
        QCOMPARE(draft.closed().outer, unitSquare().outer);
        QCOMPARE(draft.closed().holes.size(), std::size_t{1});
    }
};

RUBBLE_TEST(OutlineDraftTest)
#include "OutlineDraftTest.moc"
