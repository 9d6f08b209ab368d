#include "core/geometry/Aspect.h"
#include "core/geometry/OutlineShapes.h"
#include "tests/support/Outlines.h"

#include <QTest>

using namespace rubble;

namespace {

bool isNear(double a, double b) { return std::abs(a - b) < 1e-12 * b; }  // a few roundings

}  // namespace

class AspectTest : public QObject {
    Q_OBJECT
private slots:
    void aRectangleIsAsLongAsItsSidesSay() { QVERIFY(isNear(aspectOf(rectangleOutline(6.0, 2.0)), 3.0)); }
    void regularPolygonsAreAsLongAsWide() {
        for (const int corners : {3, 4, 5, 6, 7}) QVERIFY(isNear(aspectOf(regularPolygonOutline(corners, 2.0)), 1.0));
        QVERIFY(isNear(aspectOf(squareRing()), 1.0));
    }
    void turningChangesNothing() {
        QVERIFY(isNear(aspectOf({{{0.0, 0.0}, {3.0, 3.0}, {2.0, 4.0}, {-1.0, 1.0}}, {}}), 3.0));
    }
    void whatHasNoAreaIsAsLongAsWide() { QCOMPARE(aspectOf({{{0.0, 0.0}, {1.0, 1.0}}, {}}), 1.0); }
};

QTEST_APPLESS_MAIN(AspectTest)
#include "AspectTest.moc"
