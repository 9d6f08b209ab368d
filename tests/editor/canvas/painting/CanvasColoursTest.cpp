#include "editor/canvas/painting/CanvasColours.h"

#include "tests/support/TestProgram.h"

#include <QGuiApplication>

using namespace rubble;

class CanvasColoursTest : public QObject {
    Q_OBJECT
private slots:
    void coloursStandOutFromTheBackgroundOfEitherTheme() {
        for (const QColor& window : {QColor(250, 250, 250), QColor(30, 30, 30)}) {
            QPalette palette(window);
            palette.setColor(QPalette::Base, window);
            const CanvasColours colours = canvasColours(palette);
            const int background = colours.background.lightness();
            QCOMPARE(background > 128, window.lightness() > 128);
            for (const QColor& ink : {colours.text, colours.outline})
                QVERIFY(std::abs(ink.lightness() - background) > 40);
        }
    }
    void layersNextToEachOtherDiffer() {
        for (std::size_t layer = 0; layer < 12; ++layer) {
            QVERIFY(layerColour(layer) != layerColour(layer + 1));
            QVERIFY(layerColour(layer).lightness() < 160);
        }
    }
};

RUBBLE_TEST_WITH(CanvasColoursTest, QGuiApplication)
#include "CanvasColoursTest.moc"
