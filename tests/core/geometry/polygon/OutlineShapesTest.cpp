#include "core/geometry/polygon/OutlineShapes.h"
#include "core/geometry/polygon/PolygonFaults.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class OutlineShapesTest : public QObject {
    Q_OBJECT
private slots:
    void shapesHaveTheirSizeAndAreCentred() {
        for (const Polygon& shape : {rectangleOutline(3.0, 2.0), isoscelesTriangleOutline(3.0, 2.0)}) {
            QVERIFY(validated(shape));
            const Box2 bounds = boundsOf(shape.outer);
            QVERIFY((bounds.min == Vec2{-1.5, -1.0} && bounds.max == Vec2{1.5, 1.0}));
        }
        QCOMPARE(area(rectangleOutline(3.0, 2.0)), 6.0);
        QCOMPARE(area(isoscelesTriangleOutline(3.0, 2.0)), 3.0);
    }
    void polygonsAreRegularWithALevelEdge() {
        for (int corners = 3; corners <= 64; ++corners) {
            const Polygon polygon = regularPolygonOutline(corners, 2.0);
            QVERIFY(validated(polygon) && isConvex(polygon.outer));
            QVERIFY(std::abs(polygon.outer[0].y - polygon.outer[1].y) < 1e-15);
            const double side = perimeter(polygon.outer) / corners;
            QVERIFY(std::abs(side - 2.0 * std::sin(M_PI / corners)) < 1e-12);
        }
    }
};

RUBBLE_TEST(OutlineShapesTest)
#include "OutlineShapesTest.moc"
