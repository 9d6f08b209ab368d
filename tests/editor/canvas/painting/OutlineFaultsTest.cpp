#include "editor/canvas/painting/OutlineFaults.h"

#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QApplication>

using namespace rubble;

class OutlineFaultsTest : public QObject {
    Q_OBJECT
private slots:
    void validOutlineHasNone() { QVERIFY(outlineFaults(unitSquare()).empty()); }
    void crossingAndNarrowOutlinesHaveSome() {
        QVERIFY(!outlineFaults({{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}}).empty());
        QVERIFY(!outlineFaults({{{0, 0}, {1, 0}, {1, 1}, {1e-14, 1}}, {{{0.5, 0.5}, {0.5, 2.0}, {0.6, 0.5}}}}).empty());
    }
    void ringsAreTheOutlineAndItsHoles() {
        Polygon frame = unitSquare();
        frame.holes = {{{0.25, 0.25}, {0.25, 0.75}, {0.75, 0.25}}};
        QCOMPARE(ringCount(frame), 2);
        QCOMPARE(ringOf(frame, 0).size(), std::size_t{4});
        QCOMPARE(ringOf(frame, 1).size(), std::size_t{3});
        ringOf(frame, 1).push_back({0.6, 0.6});
        QCOMPARE(frame.holes[0].size(), std::size_t{4});
    }
    void faultIsMarkedWhereItIs() {
        const Polygon bow{{{0, 0}, {1, 1}, {1, 0}, {0, 1}}, {}};
        const CanvasView view{.size = {400.0, 400.0}, .centre = {0.5, 0.5}, .scale = 300.0};
        QImage image(400, 400, QImage::Format_RGB32);
        image.fill(Qt::magenta);
        QPainter painter(&image);
        const CanvasColours colours = canvasColours(QPalette());
        paintFaults(painter, bow, outlineFaults(bow), view, colours);
        painter.end();
        bool isMarked = false;
        for (int y = 185; y < 215; ++y) {
            for (int x = 185; x < 215; ++x) isMarked |= image.pixelColor(x, y) == colours.fault;
        }
        QVERIFY(isMarked);
    }
};

RUBBLE_TEST_WITH(OutlineFaultsTest, QApplication)
#include "OutlineFaultsTest.moc"
