#include "editor/commands/BrushSize.h"

#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

class BrushSizeTest : public QObject {
    Q_OBJECT
private slots:
    void stepsAreAQuarterEach() {
        BrushSize size;
        size.setRadiusPixels(100.0);
        size.step(1.0);
        QCOMPARE(size.radiusPixels(), 125.0);
        size.step(-1.0);
        QCOMPARE(size.radiusPixels(), 100.0);
    }
    void radiusStaysInRange() {
        BrushSize size;
        size.setRadiusPixels(1.0);
        QCOMPARE(size.radiusPixels(), 3.0);
        size.step(100.0);
        QCOMPARE(size.radiusPixels(), 400.0);
    }
};

RUBBLE_TEST(BrushSizeTest)
#include "BrushSizeTest.moc"
