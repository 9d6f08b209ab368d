#include "core/asset/PieceColours.h"
#include "core/base/Random.h"
#include "tests/support/Canvas.h"

#include <QSignalSpy>
#include <QTest>
#include <QWheelEvent>

using namespace rubble;

namespace {

PlacedSeeds twoSeeds() { return {{{0, {0.25, 0.5}}, {1, {0.75, 0.5}}}}; }

QImage pictureOf(CanvasBench& bench) { return bench.canvas.grab().toImage(); }

QRgb pixelAt(CanvasBench& bench, Vec2 at) {
    const QImage picture = pictureOf(bench);
    return picture.pixel(bench.pixels(at) * picture.devicePixelRatio()) & 0xffffff;
}

/// Layers that leave nothing of the pointer and the legend.
void setPlain(CanvasBench& bench) {
    CanvasLayers layers = bench.canvas.layers();
    layers.hasLegend = false;
    bench.canvas.setLayers(layers);
    QEvent leave(QEvent::Leave);
    QCoreApplication::sendEvent(&bench.canvas, &leave);
}

constexpr int kSmoothing = 8;         // of 255 in a channel: less is not seen
constexpr double kLinesPart = 0.002;  // of all pixels: Qt smooths a long line a little otherwise where it is clipped

/// The part of all pixels that differ so much that it is seen.
double differentPart(const QImage& a, const QImage& b) {
    int different = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QRgb one = a.pixel(x, y), other = b.pixel(x, y);
            different += std::abs(qRed(one) - qRed(other)) > kSmoothing ||
                         std::abs(qGreen(one) - qGreen(other)) > kSmoothing ||
                         std::abs(qBlue(one) - qBlue(other)) > kSmoothing;
        }
    }
    return static_cast<double>(different) / (a.width() * a.height());
}

/// The picture with every layer painted anew.
QImage repainted(CanvasBench& bench) {
    const CanvasLayers layers = bench.canvas.layers();
    bench.canvas.setLayers({.hasGrid = !layers.hasGrid});
    bench.canvas.grab();
    bench.canvas.setLayers(layers);
    return pictureOf(bench);
}

}  // namespace

class PatternCanvasTest : public QObject {
    Q_OBJECT
private slots:
    void theOutlineFitsUntilTheViewIsMoved() {
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
    void theWheelZoomsToThePointer() {
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
    void theMiddleButtonAndSpacePan() {
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
    void aCellHasThePieceColour() {
        CanvasBench bench(projectOf(unitSquare(), twoSeeds()));
        setPlain(bench);
        QCOMPARE(pixelAt(bench, {0.1, 0.5}), packed(pieceColour("2/3.0")));
        QCOMPARE(pixelAt(bench, {0.9, 0.5}), packed(pieceColour("2/3.1")));
    }
    void aHiddenPieceIsHatched() {
        CanvasBench bench(projectOf(unitSquare(), twoSeeds()));
        setPlain(bench);
        bench.selection.setHidden({.seeds = {{3, 1}}});
        QVERIFY(pixelAt(bench, {0.9, 0.5}) != packed(pieceColour("2/3.1")));
        QCOMPARE(pixelAt(bench, {0.1, 0.5}), packed(pieceColour("2/3.0")));
    }
    void theLargestCellHasTheEndOfTheScale() {
        CanvasBench bench(projectOf(unitSquare(), PlacedSeeds{{{0, {0.1, 0.5}}, {1, {0.5, 0.5}}}}));
        setPlain(bench);
        CanvasLayers layers = bench.canvas.layers();
        layers.colouring = CellColouring::Area;
        bench.canvas.setLayers(layers);
        QCOMPARE(pixelAt(bench, {0.9, 0.25}), packed(rampColour(1.0)));
        QCOMPARE(pixelAt(bench, {0.05, 0.25}), packed(rampColour(0.0)));
    }
    void whatIsPaintedInPartsLooksAsIfItWerePaintedAtOnce() {
        for (const std::uint32_t seeds : {12u, 3000u}) {
            CanvasBench bench(projectOf(squareRing(), UniformScatter{.count = seeds}));
            setPlain(bench);
            CanvasLayers layers = bench.canvas.layers();
            layers.hasTriangles = seeds < 100;
            bench.canvas.setLayers(layers);
            Random random(seeds);
            for (int step = 0; step < 5; ++step) {
                const Vec2 from = bench.seedAt(random.below(seeds));
                bench.drag(from, from + Vec2(random.unit() - 0.5, random.unit() - 0.5) * 0.4);
                bench.canvas.setView(panned(bench.canvas.view(), {random.unit() > 0.5 ? 17.0 : -9.0, 5.0}));
                setPlain(bench);
                const QImage inParts = pictureOf(bench);
                const double off = differentPart(inParts, repainted(bench));
                QVERIFY2(off <= kLinesPart, qPrintable(QString("%1 seeds, step %2: %3").arg(seeds).arg(step).arg(off)));
            }
        }
    }
    void aDraggedSeedHasItsCellsBeforeThePatternIsBaked() {
        for (const std::uint32_t seeds : {3u, 30u, 3000u}) {
            CanvasBench bench(projectOf(squareRing(), UniformScatter{.count = seeds}));
            setPlain(bench);
            Random random(seeds);
            const Vec2 from = bench.seedAt(random.below(seeds));
            bench.press(from);
            for (int step = 0; step < 20; ++step) {
                bench.moveTo(from + Vec2(random.unit() - 0.5, random.unit() - 0.5) * 0.6);
                QVERIFY(*bench.canvas.shownAsset() == bench.asset());
                const QImage atOnce = pictureOf(bench);
                QVERIFY(*bench.canvas.shownPattern()->baked().asset != bench.asset());
                if (step % 3 == 0) continue;  // what was baked is older than the last move
                bench.settle();
                const double off = differentPart(atOnce, repainted(bench));
                QVERIFY2(off <= kLinesPart, qPrintable(QString("%1 seeds, step %2: %3").arg(seeds).arg(step).arg(off)));
            }
            bench.release(from);
        }
    }
    void equalSeedsAndThoseWithoutACellAreMarked() {
        CanvasBench bench(projectOf(unitSquare(), PlacedSeeds{{{0, {0.5, 0.5}}, {1, {0.5, 0.5}}, {2, {3.0, 3.0}}}}));
        const ShownPattern& pattern = *bench.canvas.shownPattern();
        QVERIFY(!pattern.isDuplicate(0) && pattern.isDuplicate(1) && pattern.hasNoCell(2));
        QCOMPARE(pattern.counts().duplicates, std::size_t{1});
        QCOMPARE(pattern.counts().withoutCell, std::size_t{1});
    }
    void seedsAreToldApartByHowTheyCameToStand() {
        Project project = projectOf(unitSquare(), UniformScatter{.count = 3});
        project.assets[0].pattern.layers[0].overrides = {{.index = 1, .position = {0.5, 0.5}}};
        project.assets[0].pattern.layers.push_back({.id = 4, .parameters = PlacedSeeds{{{0, {0.2, 0.2}}}}});
        CanvasBench bench(project);
        const ShownPattern& pattern = *bench.canvas.shownPattern();
        QVERIFY(pattern.origin(0) == SeedOrigin::Scattered && pattern.origin(1) == SeedOrigin::Moved);
        QVERIFY(pattern.origin(pattern.find({4, 0})) == SeedOrigin::Placed);
        QCOMPARE(pattern.counts().scattered, std::size_t{2});
        QCOMPARE(pattern.find({4, 1}), kNone);
    }
    void anEmptyCanvasAndAFaultHaveASentence() {
        CanvasBench bench(projectOf(unitSquare(), twoSeeds()));
        setPlain(bench);
        Asset asset = bench.asset();
        asset.pattern.layers[0].parameters = UniformScatter{.count = kMostSeeds + 1};
        bench.document.push(altered("Too many", asset));
        bench.settle();
        QVERIFY(!bench.canvas.shownPattern());
        QVERIFY(pixelAt(bench, {0.5, 0.5}) != pixelAt(bench, {0.5, 0.9}));  // the panel that tells it
        bench.selection.setAsset(0);
        QVERIFY(!bench.canvas.grab().isNull());
    }
    void whatIsPointedAtIsTold() {
        CanvasBench bench(projectOf(unitSquare(), twoSeeds()));
        QSignalSpy pointed(&bench.canvas, &PatternCanvas::pointed), hints(&bench.canvas, &PatternCanvas::hintChanged);
        QTest::mouseMove(&bench.canvas, bench.pixels({0.5, 0.25}));
        QCoreApplication::processEvents();
        QVERIFY(pointed.count() > 0);
        QVERIFY(std::abs(pointed.back()[1].toDouble() - 0.25) < 0.01);
        bench.canvas.setTool(CanvasToolKind::Measure);
        QVERIFY(hints.back()[0].toString().startsWith("Drag from one point"));
    }
};

QTEST_MAIN(PatternCanvasTest)
#include "PatternCanvasTest.moc"
