#include "editor/canvas/widget/CanvasFraming.h"

#include "editor/canvas/painting/RulerPainting.h"
#include "tests/support/TestProgram.h"

using namespace rubble;

namespace {

const CanvasView kFramedCanvas{.size = {800.0, 600.0}};
const Box2 kUnitBox{{0.0, 0.0}, {1.0, 1.0}};

QRectF framedPixels(const CanvasView& view, const Box2& box) {
    return QRectF(view.pixels(box.min), view.pixels(box.max)).normalized();
}

}  // namespace

class CanvasFramingTest : public QObject {
    Q_OBJECT
private slots:
    void assetLiesBetweenTheRulers() {
        const QRectF shown = framedPixels(fittedBeside(kFramedCanvas, kUnitBox, {}), kUnitBox);
        QVERIFY(shown.left() > kRulerWidth && shown.top() > kRulerWidth);
        QVERIFY(shown.right() < 800.0 && shown.bottom() < 600.0);
        QVERIFY(shown.height() > 500.0);
    }
    void assetLiesBesideTheLegend() {
        const QRectF legend(600.0, 400.0, 200.0, 200.0);
        const CanvasView view = fittedBeside(kFramedCanvas, kUnitBox, legend);
        QVERIFY(!isCovered(view, kUnitBox, legend));
        QVERIFY(isCovered(fittedBeside(kFramedCanvas, kUnitBox, {}), kUnitBox, legend));
    }
    /// Else it would be too small to be of use.
    void legendThatLeavesNoRoomIsIgnored() {
        const QRectF legend(100.0, 100.0, 700.0, 500.0);
        QCOMPARE(fittedBeside(kFramedCanvas, kUnitBox, legend), fittedBeside(kFramedCanvas, kUnitBox, {}));
    }
    void pointIsFramedWithContextAndAllOfItWithTheWhole() {
        const Box2 point{{0.5, 0.5}, {0.5, 0.5}};
        const CanvasView near = framed(kFramedCanvas, point, kUnitBox);
        QVERIFY(near.visibleBox().size().y < 0.2 && near.visibleBox().size().y > 0.02);
        QCOMPARE(near.centre, Vec2(0.5, 0.5));
        QVERIFY(framed(kFramedCanvas, kUnitBox, kUnitBox).visibleBox().size().y > 1.0);
    }
};

RUBBLE_TEST(CanvasFramingTest)
#include "CanvasFramingTest.moc"
