#include "editor/canvas/tools/BoxLassoSelection.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

using Shape = BoxLassoSelection::Shape;

class BoxLassoSelectionTest : public QObject {
    Q_OBJECT
private slots:
    void boxContainsThePointsBetweenItsCorners() {
        BoxLassoSelection area(Shape::Box, {10.0, 10.0});
        area.dragTo({50.0, 0.0});
        area.dragTo({0.0, 20.0});  // only the last corner counts
        QVERIFY(area.contains({5.0, 15.0}));
        QVERIFY(!area.contains({20.0, 5.0}));
    }
    void lassoContainsThePointsInsideItsPath() {
        BoxLassoSelection area(Shape::Lasso, {0.0, 0.0});
        for (const QPointF point : {QPointF(10.0, 0.0), QPointF(0.0, 10.0)}) area.dragTo(point);
        QVERIFY(area.contains({2.0, 2.0}));
        QVERIFY(!area.contains({8.0, 8.0}));  // in the bounding box, beyond the closing edge
    }
};

RUBBLE_TEST(BoxLassoSelectionTest)
#include "BoxLassoSelectionTest.moc"
