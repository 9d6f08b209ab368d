// Tests editor/view3d/PlayHud.cpp and viewport/widget/ScaleBarItem.cpp.
#include "editor/view3d/PlayHud.h"

#include "tests/support/TestProgram.h"
#include "viewport/widget/ScaleBarItem.h"

#include <QApplication>
#include <QImage>
#include <QPainter>
#include <QTest>

using namespace rubble;

namespace {

PlayHud::Content fullContent() {
    return {.title = "Playing at 0.25× · destruction off",
            .statistics = {"12.34 s · step 740 · 0.52 ms per step", "bodies: 1,400, asleep: 200", "no breaks"},
            .hint = "F: throw, hold to charge · H: hammer · X: blast, Ctrl and wheel: its radius · Drag: grab",
            .hasHeat = true,
            .isForecast = true};
}

}  // namespace

class PlayHudTest : public QObject {
    Q_OBJECT
private slots:
    void hiddenHudHasNoPlates() {
        PlayHud hud;
        hud.setContent(fullContent());
        QVERIFY(hud.plates({800, 600}, QFont()).empty());
    }
    void platesKeepClearOfEachOtherAndOfTheScaleBar() {
        PlayHud hud;
        hud.setVisible(true);
        hud.setContent(fullContent());
        for (int width = 320; width <= 2000; width += 40) {
            const QSize size(width, 700);
            for (const int points : {9, 14}) {
                std::vector<QRect> plates = hud.plates(size, QFont(QString(), points));
                QCOMPARE(plates.size(), 3u);
                const int side = ScaleBarItem::maxWidth();
                plates.push_back({width - side, 700 - 48, side, 48});
                for (std::size_t k = 0; k < plates.size(); ++k) {
                    for (std::size_t other = 0; other < k; ++other) {
                        QVERIFY2(!plates[k].intersects(plates[other]), qPrintable(QString::number(width)));
                    }
                }
            }
        }
    }
    /// The view is framed anew where plates change; the line comes and goes with the pointer.
    void whatWouldFallChangesNoPlates() {
        PlayHud hud;
        hud.setVisible(true);
        PlayHud::Content content = fullContent();
        hud.setContent(content);
        const std::vector<QRect> before = hud.plates({1200, 700}, QFont());
        content.collapse = "Without block 0, 4 bodies would fall: 2000 kg, for up to 0.6 s, and so on and on and on";
        hud.setContent(content);
        QCOMPARE(hud.plates({1200, 700}, QFont()), before);
        QVERIFY(hud.accessibleText().contains("would fall"));
    }
    void chargeStaysInALowView() {
        const auto lowestRows = [](std::optional<double> charge) {
            PlayHud hud;
            hud.setVisible(true);
            hud.setContent({.charge = charge, .chargeText = "95.0 m/s"});
            QImage image(340, 110, QImage::Format_RGB32);
            image.fill(Qt::gray);
            QPainter painter(&image);
            hud.paint(painter, image.size());
            painter.end();
            return image.copy(0, 105, 340, 5);
        };
        QVERIFY(lowestRows(0.5) == lowestRows(std::nullopt));
    }
    void hintIsLeftOutWhereItWouldCoverTheTexts() {
        PlayHud hud;
        hud.setVisible(true);
        hud.setContent({.title = "Paused", .hint = fullContent().hint});
        QCOMPARE(hud.plates({320, 700}, QFont()).size(), 2u);
        QCOMPARE(hud.plates({320, 120}, QFont()).size(), 1u);
    }
};

RUBBLE_TEST_WITH(PlayHudTest, QApplication)
#include "PlayHudTest.moc"
