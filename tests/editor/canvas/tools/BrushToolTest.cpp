// Tests editor/canvas/tools/BrushTool.cpp and editor/widgets/input/BrushRing.cpp.
#include "editor/canvas/tools/BrushTool.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Canvas.h"

#include <QTest>
#include <QWheelEvent>

#include <algorithm>

using namespace rubble;

namespace {

struct BrushBench : CanvasBench {
    explicit BrushBench(LayerParameters parameters) : CanvasBench(projectOf(unitSquare(), std::move(parameters))) {
        canvas.setTool(CanvasToolKind::Brush);
        canvas.brushTool().setStrength(1.0);
    }
    const GreyImage* picture() const {
        return std::get<DensityImage>(asset().pattern.layers.back().parameters).image.get();
    }
};

}  // namespace

class BrushToolTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void dragIsOneUndoStepAndMovesSeeds() {
        BrushBench bench(DensityImage{.count = 50});
        bench.drag({0.1, 0.75}, {0.9, 0.75});
        QVERIFY(bench.picture());
        QCOMPARE(bench.document.undoStack().count(), 1);
        const std::size_t seeds = bench.canvas.displayedPattern()->seeds().positions.size();
        QVERIFY(seeds > 0);
        for (std::size_t seed = 0; seed < seeds; ++seed) QVERIFY(bench.seedAt(seed).y > 0.5);
        bench.document.undoStack().undo();
        bench.settle();
        QVERIFY(!bench.picture());
    }
    void shiftErases() {
        BrushBench bench(DensityImage{.count = 50});
        bench.drag({0.1, 0.75}, {0.9, 0.75});
        bench.canvas.brushTool().setRadiusPixels(200.0);
        bench.drag({0.1, 0.75}, {0.9, 0.75}, Qt::ShiftModifier);
        QVERIFY(std::ranges::all_of(bench.picture()->grey, [](std::uint16_t grey) { return grey == 255; }));
    }
    void controlAndWheelChangeTheSize() {
        BrushBench bench(DensityImage{.count = 50});
        const double before = bench.canvas.brushTool().radiusPixels();
        const double scale = bench.canvas.view().scale;
        const QPointF middle = QRectF(bench.canvas.rect()).center();
        const auto turn = [&](Qt::KeyboardModifiers modifiers) {
            QWheelEvent event(middle, middle, {}, {0, 120}, Qt::NoButton, modifiers, Qt::NoScrollPhase, false);
            QApplication::sendEvent(&bench.canvas, &event);
        };
        turn(Qt::ControlModifier);
        QVERIFY(bench.canvas.brushTool().radiusPixels() > before);
        QCOMPARE(bench.canvas.view().scale, scale);
        turn({});
        QVERIFY(bench.canvas.view().scale > scale);
        QVERIFY(bench.canvas.brushTool().hint().contains("wheel"));
    }
    void otherEditEndsAStroke() {
        BrushBench bench(DensityImage{.count = 50});
        bench.press({0.1, 0.75});
        bench.moveTo({0.3, 0.75});
        bench.renameAsset("renamed");
        bench.moveTo({0.9, 0.75});
        bench.release({0.9, 0.75});
        QCOMPARE(bench.asset().name, std::string("renamed"));
    }
    void strokesKeepTheDensityOfSeeds() {
        BrushBench bench(PlacedSeeds{});
        bench.drag({0.1, 0.2}, {0.9, 0.2});
        const std::size_t first = bench.canvas.displayedPattern()->seeds().positions.size();
        QVERIFY2(first > 5 && first < 40, qPrintable(QString::number(first)));  // a fifth of 4 * 20 seeds
        bench.drag({0.1, 0.8}, {0.9, 0.8});
        const std::vector<Vec2> seeds = bench.canvas.displayedPattern()->seeds().positions;
        QVERIFY2(seeds.size() >= 2 * first - 2 && seeds.size() <= 2 * first + 2,
                 qPrintable(QString("%1, %2").arg(first).arg(seeds.size())));
        bench.drag({0.1, 0.2}, {0.9, 0.2}, Qt::ShiftModifier);
        QVERIFY(bench.canvas.displayedPattern()->seeds().positions.size() < seeds.size());
    }
    void ringLeavesWithThePointer() {
        BrushBench bench(PlacedSeeds{});
        QTest::mouseMove(&bench.canvas, bench.pixels({0.5, 0.5}));
        const QImage with = bench.canvas.grab().toImage();
        QEvent leave(QEvent::Leave);
        QCoreApplication::sendEvent(&bench.canvas, &leave);
        const QPoint ring = bench.pixels({0.5, 0.5}) + QPoint(30, 0);
        const auto around = [&](const QImage& image) { return image.copy(QRect(ring - QPoint(4, 4), QSize(8, 8))); };
        QVERIFY(around(bench.canvas.grab().toImage()) != around(with));
    }
    void addsALayerIfThereIsNone() {
        BrushBench bench(PlacedSeeds{});
        bench.drag({0.2, 0.2}, {0.4, 0.2});
        QCOMPARE(bench.asset().pattern.layers.size(), std::size_t{2});
        QVERIFY(bench.picture());
        QCOMPARE(bench.document.undoStack().count(), 1);
    }
};

RUBBLE_TEST_WITH(BrushToolTest, QApplication)
#include "BrushToolTest.moc"
