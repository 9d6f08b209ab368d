#include "editor/canvas/widget/CanvasFraming.h"

#include "editor/canvas/painting/RulerPainting.h"
#include "tests/support/TestProgram.h"

using namespace rubble;

namespace {

const CanvasView kCanvas{.size = {800.0, 600.0}};
const Box2 kUnit{{0.0, 0.0}, {1.0, 1.0}};

QRectF pixels(const CanvasView& view, const Box2& box) {
    return QRectF(view.pixels(box.min), view.pixels(box.max)).normalized();
}

}  // namespace

class CanvasFramingTest : public QObject {
    Q_OBJECT
private slots:
    void assetLiesBetweenTheRulers() {
        const QRectF shown = pixels(fittedBeside(kCanvas, kUnit, {}), kUnit);
        QVERIFY(shown.left() > kRulerWidth && shown.top() > kRulerWidth);
        QVERIFY(shown.right() < 800.0 && shown.bottom() < 600.0);
        QVERIFY(shown.height() > 500.0);
    }
    void assetLiesBesideTheLegend() {
        const QRectF legend(600.0, 400.0, 200.0, 200.0);
        const CanvasView view = fittedBeside(kCanvas, kUnit, legend);
        QVERIFY(!isCovered(view, kUnit, legend));
        QVERIFY(isCovered(fittedBeside(kCanvas, kUnit, {}), kUnit, legend));
    }
    /// Else it would be too small to be of use.
    void legendThatLeavesNoRoomIsIgnored() {
        const QRectF legend(100.0, 100.0, 700.0, 500.0);
        QCOMPARE(fittedBeside(kCanvas, kUnit, legend), fittedBeside(kCanvas, kUnit, {}));
    }
    void pointIsFramedWithContextAndAllOfItWithTheWhole() {
        const Box2 point{{0.5, 0.5}, {0.5, 0.5}};
        const CanvasView near = framed(kCanvas, point, kUnit);
        QVERIFY(near.visibleBox().size().y < 0.2 && near.visibleBox().size().y > 0.02);
        QCOMPARE(near.centre, Vec2(0.5, 0.5));
        QVERIFY(framed(kCanvas, kUnit, kUnit).visibleBox().size().y > 1.0);
    }
};

RUBBLE_TEST(CanvasFramingTest)
#include "CanvasFramingTest.moc"
