#include "editor/canvas/painting/CanvasView.h"
#include "tests/support/TestProgram.h"

#include <QTest>

using namespace rubble;

namespace {

const CanvasView kView{.size = {400.0, 300.0}, .centre = {1.0, 2.0}, .scale = 100.0};

}  // namespace

class CanvasViewTest : public QObject {
    Q_OBJECT
private slots:
    void yPointsUpInMetresAndDownInPixels() {
        QCOMPARE(kView.pixels({1.0, 2.0}), QPointF(200.0, 150.0));
        QCOMPARE(kView.pixels({2.0, 3.0}), QPointF(300.0, 50.0));
        QCOMPARE(kView.metres({300.0, 50.0}), Vec2(2.0, 3.0));
    }
    void visibleBoxHasTheSizeOfTheCanvas() {
        QCOMPARE(kView.visibleBox().min, Vec2(-1.0, 0.5));
        QCOMPARE(kView.visibleBox().max, Vec2(3.0, 3.5));
    }
    void zoomKeepsThePointUnderThePointer() {
        const CanvasView view = zoomed(kView, 2.0, {300.0, 50.0});
        QCOMPARE(view.scale, 200.0);
        QCOMPARE(view.metres({300.0, 50.0}), Vec2(2.0, 3.0));
    }
    void zoomIsLimited() {
        QCOMPARE(zoomed(kView, 1e300, {}).scale, 1e7);
        QCOMPARE(zoomed(kView, 1e-300, {}).scale, 1e-3);
    }
    void panMovesThePictureWithThePointer() { QCOMPARE(panned(kView, {100.0, 50.0}).centre, Vec2(0.0, 2.5)); }
    void fittedBoxFillsTheCanvasLessTheMargin() {
        const CanvasView view = fitted(kView, QRectF({}, kView.size), {{0.0, 0.0}, {2.0, 1.0}}, 50.0);
        QCOMPARE(view.centre, Vec2(1.0, 0.5));
        QCOMPARE(view.scale, 150.0);  // 300 pixels for 2 m; the height would allow 200
        QVERIFY(fitted(kView, QRectF({}, kView.size), Box2{}, 50.0) == kView);
    }
    void fittedBoxIsCentredInTheArea() {
        const QRectF area(100.0, 20.0, 220.0, 200.0);
        const CanvasView view = fitted(kView, area, {{0.0, 0.0}, {2.0, 1.0}}, 10.0);
        QCOMPARE(view.scale, 100.0);
        QCOMPARE(view.pixels({0.0, 0.5}), QPointF(110.0, 120.0));
        QCOMPARE(view.pixels({2.0, 0.5}), QPointF(310.0, 120.0));
    }
};

RUBBLE_TEST(CanvasViewTest)
#include "CanvasViewTest.moc"
