#include "editor/canvas/painting/LegendPainting.h"

#include "core/fracture/voronoi/VoronoiPartition.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <QApplication>

using namespace rubble;

namespace {

const CanvasView kLegendCanvas{.size = {640.0, 480.0}, .scale = 300.0};

CanvasContents legendContents(CellColouring colouring, std::uint32_t seeds = 6) {
    auto baked = std::make_shared<BakedPattern>();
    baked->asset = std::make_shared<const Asset>(boxAsset(2, 3, UniformScatter{.count = seeds}));
    baked->seeds = *seedsOf(baked->asset->pattern, baked->asset->prism().outline);
    baked->triangulation = *triangulate(baked->seeds.positions);
    baked->partition = *voronoiPartition(baked->asset->prism().outline, baked->triangulation);
    CanvasContents contents;
    contents.pattern = std::make_shared<const DrawablePattern>(std::move(baked));
    contents.overlays.colouring = colouring;
    contents.range = contents.pattern->range(colouring);
    return contents;
}

/// The height of a legend, pixels.
double legendHeight(const CanvasContents& contents) {
    return legendArea(QFont(), kLegendCanvas, contents, canvasColours(QPalette())).height();
}

}  // namespace

class LegendPaintingTest : public QObject {
    Q_OBJECT
private slots:
    void legendLiesInTheLowerRightCorner() {
        const QRectF area =
            legendArea(QFont(), kLegendCanvas, legendContents(CellColouring::Fragment), canvasColours(QPalette()));
        QVERIFY(!area.isEmpty());
        QVERIFY(QRectF(QPointF(), kLegendCanvas.size).contains(area));
        QVERIFY(area.center().x() > 320.0 && area.center().y() > 240.0);
    }
    void nothingIsExplainedWithoutAPattern() {
        QVERIFY(legendArea(QFont(), kLegendCanvas, {}, canvasColours(QPalette())).isEmpty());
    }
    void quantitiesHaveAScale() {
        QVERIFY(legendHeight(legendContents(CellColouring::Area)) >
                legendHeight(legendContents(CellColouring::Fragment)));
    }
    void valuesAtTheEndsDoNotOverlap() {
        CanvasContents contents = legendContents(CellColouring::Volume);
        const auto width = [&] {
            return legendArea(QFont(), kLegendCanvas, contents, canvasColours(QPalette())).width();
        };
        contents.range = {1.0, 2.0};
        const double usual = width();
        contents.range = {0.00008915, 0.05566};  // m³
        QVERIFY(width() > usual);
    }
    void eachOverlayHasARow() {
        CanvasContents contents = legendContents(CellColouring::Fragment);
        double before = legendHeight(contents);
        for (bool CanvasOverlays::*overlay :
             {&CanvasOverlays::hasTriangles, &CanvasOverlays::hasWholeVoronoi, &CanvasOverlays::hasBonds}) {
            contents.overlays.*overlay = true;
            QVERIFY(legendHeight(contents) > before);
            before = legendHeight(contents);
        }
    }
    void overlaysThatDrawNothingHaveNoRow() {
        CanvasContents contents = legendContents(CellColouring::Fragment, 1);
        const double before = legendHeight(contents);
        contents.overlays.hasTriangles = contents.overlays.hasWholeVoronoi = true;
        QCOMPARE(legendHeight(contents), before);
    }
    /// As the seeds of the canvas.
    void seedsHaveTheColourOfTheirLayer() {
        const CanvasContents contents = legendContents(CellColouring::Fragment);
        QImage image(640, 480, QImage::Format_RGB32);
        QPainter painter(&image);
        const QRect area = paintLegend(painter, kLegendCanvas, contents, canvasColours(QPalette())).toRect();
        painter.end();
        int count = 0;
        for (int y = area.top(); y < area.bottom(); ++y) {
            for (int x = area.left(); x < area.right(); ++x) count += image.pixelColor(x, y) == layerColour(0) ? 1 : 0;
        }
        QVERIFY2(count > 20, qPrintable(QString::number(count)));
    }
    void paintsItsAreaOnly() {
        const CanvasContents contents = legendContents(CellColouring::Area);
        QImage image(640, 480, QImage::Format_RGB32);
        image.fill(Qt::magenta);
        QPainter painter(&image);
        const QRectF area = paintLegend(painter, kLegendCanvas, contents, canvasColours(QPalette()));
        painter.end();
        QCOMPARE(area, legendArea(painter.font(), kLegendCanvas, contents, canvasColours(QPalette())));
        const QRect around = area.toAlignedRect().adjusted(-1, -1, 1, 1);
        bool isPainted = false;
        for (int y = 0; y < 480; ++y) {
            for (int x = 0; x < 640; ++x) {
                const bool isChanged = image.pixelColor(x, y) != QColor(Qt::magenta);
                isPainted |= isChanged;
                QVERIFY(!isChanged || around.contains(x, y));
            }
        }
        QVERIFY(isPainted);
    }
};

RUBBLE_TEST_WITH(LegendPaintingTest, QApplication)
#include "LegendPaintingTest.moc"
