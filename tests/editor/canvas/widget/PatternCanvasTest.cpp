// Tests editor/canvas/widget/PatternCanvas.cpp, editor/canvas/widget/CanvasContentsUpdater.cpp,
// editor/canvas/painting/CanvasBackingStore.cpp and editor/canvas/painting/DrawablePattern.cpp.
#include "core/asset/project/FragmentColours.h"
#include "core/base/Random.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Canvas.h"

#include <QLineEdit>
#include <QSignalSpy>
#include <QTest>
#include <QTimer>
#include <QVBoxLayout>
#include <QWheelEvent>

using namespace rubble;

namespace {

PlacedSeeds twoSeeds() { return {{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}}; }

QImage pictureOf(CanvasBench& bench) { return bench.canvas.grab().toImage(); }

QRgb pixelAt(CanvasBench& bench, Vec2 at) {
    const QImage picture = pictureOf(bench);
    return picture.pixel(bench.pixels(at) * picture.devicePixelRatio()) & 0xffffff;
}

/// Hides the legend and everything under the pointer.
void setPlain(CanvasBench& bench) {
    CanvasOverlays overlays = bench.canvas.overlays();
    overlays.hasLegend = false;
    bench.canvas.setOverlays(overlays);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&bench.canvas, &leave);
}

constexpr int kChannelTolerance = 8;      // of 255 in a channel; less is invisible
constexpr double kLineTolerance = 0.002;  // of all pixels: Qt's antialiasing of long lines depends on clipping

/// The fraction of pixels that differ visibly.
double differingFraction(const QImage& a, const QImage& b) {
    int different = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QRgb one = a.pixel(x, y), other = b.pixel(x, y);
            different += std::abs(qRed(one) - qRed(other)) > kChannelTolerance ||
                         std::abs(qGreen(one) - qGreen(other)) > kChannelTolerance ||
                         std::abs(qBlue(one) - qBlue(other)) > kChannelTolerance;
        }
    }
    return static_cast<double>(different) / (a.width() * a.height());
}

/// Moves the pointer while no button is held.
void moveWithoutButton(CanvasBench& bench, Vec2 at) {
    const QPointF position(bench.pixels(at));
    QMouseEvent event(QEvent::MouseMove, position, bench.canvas.mapToGlobal(position), Qt::NoButton, Qt::NoButton, {});
    QCoreApplication::sendEvent(&bench.canvas, &event);
}

/// The image after a full repaint.
QImage repainted(CanvasBench& bench) {
    const CanvasOverlays overlays = bench.canvas.overlays();
    bench.canvas.setOverlays({.hasGrid = !overlays.hasGrid});
    bench.canvas.grab();
    bench.canvas.setOverlays(overlays);
    return pictureOf(bench);
}

}  // namespace

class PatternCanvasTest : public QObject {
    Q_OBJECT
private slots:
    void outlineStaysFittedUntilTheViewMoves() {
        CanvasBench bench(projectOf(unitSquare(), twoSeeds()));
        const QRect inside = bench.canvas.rect();
        QVERIFY(inside.contains(bench.pixels({0.0, 0.0})) && inside.contains(bench.pixels({1.0, 1.0})));
        bench.canvas.resize(300, 700);
        QVERIFY(bench.canvas.rect().contains(bench.pixels({1.0, 1.0})));
        bench.canvas.zoomBy(2.0);
        const double scale = bench.canvas.view().scale;
        bench.canvas.resize(640, 480);
        QCOMPARE(bench.canvas.view().scale, scale);
        bench.canvas.fit();
        QVERIFY(bench.canvas.view().scale < scale);
    }
    void fittedOutlineLiesBesideTheLegend() {
        CanvasBench bench(projectOf(unitSquare(), twoSeeds()));
        CanvasOverlays overlays = bench.canvas.overlays();
        overlays.hasLegend = true;
        bench.canvas.setOverlays(overlays);
        for (const QSize size : {QSize(400, 400), QSize(640, 480), QSize(300, 700), QSize(900, 250)}) {
            bench.canvas.resize(size);
            const auto isBeside = [&] {
                const QRectF outline(bench.canvas.view().pixels({0.0, 1.0}), bench.canvas.view().pixels({1.0, 0.0}));
                return QRectF(bench.canvas.rect()).contains(outline) && !outline.intersects(bench.canvas.legendArea());
            };
            QVERIFY(!bench.canvas.legendArea().isEmpty() && isBeside());
            overlays.hasBonds = !overlays.hasBonds;  // another row
            bench.canvas.setOverlays(overlays);
            QVERIFY(isBeside());
        }
        bench.canvas.resize(150, 150);  // too small for both
        QVERIFY(bench.canvas.view().scale > 50.0);
    }
    void wheelZoomsToThePointer() {
        CanvasBench bench(projectOf(unitSquare(), twoSeeds()));
        const QPointF at(200.0, 150.0);
        const Vec2 before = bench.canvas.view().metres(at);
        const double scale = bench.canvas.view().scale;
        QWheelEvent event(at, bench.canvas.mapToGlobal(at), {}, {0, 240}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
        QCoreApplication::sendEvent(&bench.canvas, &event);
        QVERIFY(std::abs(bench.canvas.view().scale / scale - 1.44) < 1e-12);
        const Vec2 off = bench.canvas.view().metres(at) - before;
        QVERIFY(std::abs(off.x) < 1e-12 && std::abs(off.y) < 1e-12);
    }
    void middleButtonAndSpacePan() {
        CanvasBench bench(projectOf(unitSquare(), twoSeeds()));
        for (const bool isSpace : {false, true}) {
            const Vec2 before = bench.canvas.view().centre;
            const Qt::MouseButton button = isSpace ? Qt::LeftButton : Qt::MiddleButton;
            if (isSpace) QTest::keyPress(&bench.canvas, Qt::Key_Space);
            QTest::mousePress(&bench.canvas, button, {}, {300, 200});
            QTest::mouseMove(&bench.canvas, {340, 180});
            QTest::mouseRelease(&bench.canvas, button, {}, {340, 180});
            if (isSpace) QTest::keyRelease(&bench.canvas, Qt::Key_Space);
            const Vec2 by = (bench.canvas.view().centre - before) * bench.canvas.view().scale;
            QVERIFY(std::abs(by.x + 40.0) < 1e-9 && std::abs(by.y + 20.0) < 1e-9);
        }
        QCOMPARE(bench.document.undoStack().count(), 0);
    }
    void dragEndsWithItsOwnButton() {
        CanvasBench bench(projectOf(unitSquare(), twoSeeds()));
        const Vec2 seed = bench.seedAt(0);
        bench.press(seed);
        bench.moveTo(seed + Vec2(0.1, 0.0));
        QTest::mousePress(&bench.canvas, Qt::MiddleButton, {}, bench.pixels(seed));
        QTest::mouseRelease(&bench.canvas, Qt::LeftButton, {}, bench.pixels(seed));
        QTest::mouseRelease(&bench.canvas, Qt::MiddleButton, {}, bench.pixels(seed));
        bench.settle();
        const Project before = bench.document.project();
        moveWithoutButton(bench, seed + Vec2(0.3, 0.2));
        QVERIFY(bench.document.project() == before);
    }
    void missedReleaseEndsADrag() {
        CanvasBench bench(projectOf(unitSquare(), twoSeeds()));
        const Vec2 seed = bench.seedAt(0);
        bench.press(seed);
        bench.moveTo(seed + Vec2(0.1, 0.0));
        const Project before = bench.document.project();
        moveWithoutButton(bench, seed + Vec2(0.3, 0.2));
        QVERIFY(bench.document.project() == before);
    }
    void noMenuOpensDuringADrag() {
        CanvasBench bench(projectOf(unitSquare(), twoSeeds()));
        bench.press(bench.seedAt(0));
        bool wasOpened = false;
        QTimer watch;
        connect(&watch, &QTimer::timeout, [&] {
            QWidget* menu = QApplication::activePopupWidget();
            wasOpened = wasOpened || menu;
            if (menu) menu->close();
        });
        watch.start(0);
        const QPoint at = bench.pixels(bench.seedAt(0));
        QContextMenuEvent event(QContextMenuEvent::Mouse, at, bench.canvas.mapToGlobal(at));
        QCoreApplication::sendEvent(&bench.canvas, &event);
        QVERIFY(!wasOpened);
    }
    void tabMovesTheFocus() {
        QWidget window;
        auto* rows = new QVBoxLayout(&window);
        Document document(projectOf(unitSquare(), twoSeeds()));
        Selection selection;
        Bakes bakes;
        BondPainter painter(document, selection);
        auto* canvas = new PatternCanvas(document, selection, bakes, painter);
        auto* next = new QLineEdit;
        rows->addWidget(canvas);
        rows->addWidget(next);
        window.show();
        QApplication::setActiveWindow(&window);
        canvas->setFocus();
        QTest::keyClick(canvas, Qt::Key_Tab);
        QVERIFY(next->hasFocus());
    }
    void cellHasTheFragmentColour() {
        CanvasBench bench(projectOf(unitSquare(), twoSeeds()));
        setPlain(bench);
        QCOMPARE(pixelAt(bench, {0.1, 0.5}), packed(fragmentColour("2/3.0")));
        QCOMPARE(pixelAt(bench, {0.9, 0.5}), packed(fragmentColour("2/3.1")));
    }
    void hiddenFragmentIsHatched() {
        CanvasBench bench(projectOf(unitSquare(), twoSeeds()));
        setPlain(bench);
        bench.selection.setHidden({.seeds = {{3, 1}}});
        QVERIFY(pixelAt(bench, {0.9, 0.5}) != packed(fragmentColour("2/3.1")));
        QCOMPARE(pixelAt(bench, {0.1, 0.5}), packed(fragmentColour("2/3.0")));
    }
    void largestCellHasTheEndOfTheScale() {
        CanvasBench bench(projectOf(unitSquare(), PlacedSeeds{{{0, {0.1, 0.5}}, {1, {0.5, 0.5}}}}));
        setPlain(bench);
        CanvasOverlays overlays = bench.canvas.overlays();
        overlays.colouring = CellColouring::Area;
        bench.canvas.setOverlays(overlays);
        QCOMPARE(pixelAt(bench, {0.9, 0.25}), packed(rampColour(1.0)));
        QCOMPARE(pixelAt(bench, {0.05, 0.25}), packed(rampColour(0.0)));
    }
    void partialRepaintEqualsFullRepaint() {
        for (const std::uint32_t seeds : {12u, 3000u}) {
            CanvasBench bench(projectOf(squareRing(), UniformScatter{.count = seeds}));
            setPlain(bench);
            CanvasOverlays overlays = bench.canvas.overlays();
            overlays.hasTriangles = seeds < 100;
            bench.canvas.setOverlays(overlays);
            Random random(seeds);
            for (int step = 0; step < 5; ++step) {
                const Vec2 from = bench.seedAt(random.below(seeds));
                bench.drag(from, from + Vec2(random.unit() - 0.5, random.unit() - 0.5) * 0.4);
                bench.canvas.setView(panned(bench.canvas.view(), {random.unit() > 0.5 ? 17.0 : -9.0, 5.0}));
                setPlain(bench);
                const QImage partial = pictureOf(bench);
                const double off = differingFraction(partial, repainted(bench));
                QVERIFY2(off <= kLineTolerance,
                         qPrintable(QString("%1 seeds, step %2: %3").arg(seeds).arg(step).arg(off)));
            }
        }
    }
    void draggedSeedHasCellsBeforeTheBake() {
        for (const std::uint32_t seeds : {3u, 30u, 3000u}) {
            CanvasBench bench(projectOf(squareRing(), UniformScatter{.count = seeds}));
            setPlain(bench);
            Random random(seeds);
            const Vec2 from = bench.seedAt(random.below(seeds));
            bench.press(from);
            for (int step = 0; step < 20; ++step) {
                bench.moveTo(from + Vec2(random.unit() - 0.5, random.unit() - 0.5) * 0.6);
                QVERIFY(*bench.canvas.displayedAsset() == bench.asset());
                const QImage atOnce = pictureOf(bench);
                QVERIFY(*bench.canvas.displayedPattern()->baked().asset != bench.asset());
                if (step % 3 == 0) continue;  // without waiting for the bake
                bench.settle();
                const double off = differingFraction(atOnce, repainted(bench));
                QVERIFY2(off <= kLineTolerance,
                         qPrintable(QString("%1 seeds, step %2: %3").arg(seeds).arg(step).arg(off)));
            }
            bench.release(from);
        }
    }
    void duplicateAndCelllessSeedsAreFlagged() {
        CanvasBench bench(projectOf(unitSquare(), PlacedSeeds{{{0, {0.5, 0.5}}, {1, {0.5, 0.5}}, {2, {3.0, 3.0}}}}));
        const DrawablePattern& pattern = *bench.canvas.displayedPattern();
        QVERIFY(!pattern.isDuplicate(0) && pattern.isDuplicate(1) && pattern.hasNoCell(2));
        QCOMPARE(pattern.counts().duplicates, std::size_t{1});
        QCOMPARE(pattern.counts().withoutCell, std::size_t{1});
    }
    void seedsHaveAnOrigin() {
        Project project = projectOf(unitSquare(), UniformScatter{.count = 3});
        project.assets[0].pattern.layers[0].overrides = {{.index = 1, .position = {0.5, 0.5}}};
        project.assets[0].pattern.layers.push_back({.id = 4, .parameters = PlacedSeeds{{{0, {0.2, 0.2}}}}});
        CanvasBench bench(project);
        const DrawablePattern& pattern = *bench.canvas.displayedPattern();
        QVERIFY(pattern.origin(0) == SeedOrigin::Scattered && pattern.origin(1) == SeedOrigin::Moved);
        QVERIFY(pattern.origin(pattern.find({4, 0})) == SeedOrigin::Placed);
        QCOMPARE(pattern.counts().scattered, std::size_t{2});
        QCOMPARE(pattern.find({4, 1}), kNone);
    }
    void emptyCanvasAndErrorsShowAMessage() {
        CanvasBench bench(projectOf(unitSquare(), twoSeeds()));
        setPlain(bench);
        Asset asset = bench.asset();
        asset.pattern.layers[0].parameters = UniformScatter{.count = kMaxSeeds};
        QVERIFY(bench.document.push(modify("More than memory allows", asset)));
        bench.settle();
        QVERIFY(!bench.canvas.displayedPattern());
        QVERIFY(pixelAt(bench, {0.5, 0.5}) != pixelAt(bench, {0.5, 0.9}));  // the message's panel
        bench.selection.setAsset(0);
        QVERIFY(!bench.canvas.grab().isNull());
    }
    void pointerPositionAndHintAreEmitted() {
        CanvasBench bench(projectOf(unitSquare(), twoSeeds()));
        QSignalSpy pointed(&bench.canvas, &PatternCanvas::pointerMoved),
            hints(&bench.canvas, &PatternCanvas::hintChanged);
        QTest::mouseMove(&bench.canvas, bench.pixels({0.5, 0.25}));
        QCoreApplication::processEvents();
        QVERIFY(pointed.count() > 0);
        QVERIFY(std::abs(pointed.back()[1].toDouble() - 0.25) < 0.01);
        bench.canvas.setTool(CanvasToolKind::Measure);
        QVERIFY(hints.back()[0].toString().startsWith("Drag from one point"));
    }
};

RUBBLE_TEST_WITH(PatternCanvasTest, QApplication)
#include "PatternCanvasTest.moc"
