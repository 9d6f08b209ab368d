#include "editor/canvas/painting/HighlightPainting.h"

#include "tests/support/TestProgram.h"
#include "tests/support/editor/Canvas.h"

#include <QImage>

using namespace rubble;

namespace {

/// A square of four quarters.
Project quarters() {
    return projectOf(unitSquare(),
                     PlacedSeeds{{{0, {0.25, 0.25}}, {1, {0.75, 0.25}}, {2, {0.75, 0.75}}, {3, {0.25, 0.75}}}});
}

/// The lines of the selection: how much a pixel differs from the fill of a selected fragment.
bool isLine(const QImage& image, const CanvasBench& bench, Vec2 at) {
    const QColor accent = bench.canvas.palette().color(QPalette::Highlight);
    const QPoint place = bench.pixels(at);
    for (int y = -2; y <= 2; ++y) {
        for (int x = -2; x <= 2; ++x) {
            const QColor pixel = image.pixelColor(place + QPoint(x, y));
            const int apart = std::abs(pixel.red() - accent.red()) + std::abs(pixel.green() - accent.green()) +
                              std::abs(pixel.blue() - accent.blue());
            if (apart < 60) return true;
        }
    }
    return false;
}

}  // namespace

class HighlightPaintingTest : public QObject {
    Q_OBJECT
private slots:
    void neighboursHaveOneOutline() {
        CanvasBench bench(quarters());
        bench.selection.setSeeds({{3, 0}, {3, 1}});
        const QImage image = bench.canvas.grab().toImage();
        QVERIFY(isLine(image, bench, {0.35, 0.5}));  // the upper edges of both
        QVERIFY(isLine(image, bench, {0.65, 0.5}));
        QVERIFY(isLine(image, bench, {0.9, 0.0}));    // the outline
        QVERIFY(!isLine(image, bench, {0.5, 0.15}));  // between both
        QVERIFY(!isLine(image, bench, {0.5, 0.85}));  // between the others
    }
    void onlyTheSelectedHalfOfACellIsOutlined() {
        Project project = projectOf(unitSquare(), PlacedSeeds{{{0, {0.55, 0.5}}}});
        const CrackLines crack{{{0, {{0.5, -0.1}, {0.5, 1.1}}}}};
        project.assets[0].pattern.layers.push_back({.id = 4, .parameters = crack});
        CanvasBench bench(std::move(project));
        bench.click({0.2, 0.5});
        bench.canvas.clearFocus();
        const QImage image = bench.canvas.grab().toImage();
        QVERIFY(isLine(image, bench, {0.0, 0.3}));
        QVERIFY(!isLine(image, bench, {1.0, 0.3}));
    }
    void ringsOfDenseSeedsCoverNothing() {
        CanvasBench bench(projectOf(unitSquare(), UniformScatter{.count = 5000}));
        bench.canvas.seedTool().selectAll();
        const QImage image = bench.canvas.grab().toImage();
        int lines = 0;
        for (int k = 1; k < 20; ++k) lines += isLine(image, bench, {0.05 * k, 0.5}) ? 1 : 0;
        QVERIFY2(lines == 0, qPrintable(QString::number(lines)));
    }
};

RUBBLE_TEST_WITH(HighlightPaintingTest, QApplication)
#include "HighlightPaintingTest.moc"
