#include "core/geometry/hull/AspectRatio.h"
#include "core/geometry/polygon/OutlineShapes.h"
#include "tests/support/Closeness.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

class AspectRatioTest : public QObject {
    Q_OBJECT
private slots:
    void rectangleHasTheRatioOfItsSides() { QVERIFY(isNear(aspectRatio(rectangleOutline(6.0, 2.0)), 3.0)); }
    void regularPolygonsHaveRatioOne() {
        for (const int corners : {3, 4, 5, 6, 7})
            QVERIFY(isNear(aspectRatio(regularPolygonOutline(corners, 2.0)), 1.0));
        QVERIFY(isNear(aspectRatio(squareRing()), 1.0));
    }
    void rotationPreservesTheRatio() {
        QVERIFY(isNear(aspectRatio({{{0.0, 0.0}, {3.0, 3.0}, {2.0, 4.0}, {-1.0, 1.0}}, {}}), 3.0));
    }
    void zeroAreaHasRatioOne() { QCOMPARE(aspectRatio({{{0.0, 0.0}, {1.0, 1.0}}, {}}), 1.0); }
};

RUBBLE_TEST(AspectRatioTest)
#include "AspectRatioTest.moc"
