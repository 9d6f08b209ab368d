#include "editor/canvas/painting/LabelPainting.h"

#include "tests/support/TestProgram.h"

#include <QApplication>

using namespace rubble;

namespace {

const CanvasView kLabelledCanvas{.size = {400.0, 300.0}};

/// The rectangle in which something painted.
QRect paintedArea(const std::function<void(QPainter&, const CanvasColours&)>& paint) {
    QImage image(400, 300, QImage::Format_RGB32);
    image.fill(Qt::magenta);
    QPainter painter(&image);
    paint(painter, canvasColours(QPalette()));
    painter.end();
    QRect rectangle;
    for (int y = 0; y < 300; ++y) {
        for (int x = 0; x < 400; ++x) {
            if (image.pixelColor(x, y) != QColor(Qt::magenta)) rectangle |= QRect(x, y, 1, 1);
        }
    }
    return rectangle;
}

QRect cornerLabel(std::vector<LabelObstacle> obstacles) {
    return paintedArea([&](QPainter& painter, const CanvasColours& colours) {
        paintCornerLabel(painter, {"3.1", "0.25 m²"}, obstacles, colours, colours.accent, kLabelledCanvas);
    });
}

}  // namespace

class LabelPaintingTest : public QObject {
    Q_OBJECT
private slots:
    void labelStaysWithinTheCanvas() {
        for (const QPointF at : {QPointF(0, 0), QPointF(399, 0), QPointF(0, 299), QPointF(399, 299)}) {
            const QRect label = paintedArea([&](QPainter& painter, const CanvasColours& colours) {
                paintLabel(painter, at, {"The outline crosses itself"}, colours, colours.fault, kLabelledCanvas);
            });
            QVERIFY(label.width() > 50 && label.width() < 390);
            QVERIFY(label.top() > 0 && label.left() > 0 && label.bottom() < 299 && label.right() < 399);
        }
    }
    void cornerLabelPrefersTheLowerLeft() {
        const QRect label = cornerLabel({});
        QVERIFY(label.right() < 200 && label.top() > 150);
    }
    void cornerLabelAvoidsWhatWeighsMost() {
        const QRect label = cornerLabel({{{0.0, 150.0, 400.0, 150.0}, 10.0}, {{0.0, 0.0, 200.0, 150.0}, 1.0}});
        QVERIFY(label.left() > 200 && label.bottom() < 150);
    }
};

RUBBLE_TEST_WITH(LabelPaintingTest, QApplication)
#include "LabelPaintingTest.moc"
