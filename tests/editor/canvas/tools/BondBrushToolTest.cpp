#include "editor/canvas/tools/BondBrushTool.h"

#include "core/structure/capacity/BondCapacities.h"
#include "editor/document/EnteredFragment.h"
#include "editor/widgets/NumberField.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Canvas.h"

#include <QMenu>
#include <QSignalSpy>
#include <QWheelEvent>

using namespace rubble;

namespace {

/// A unit square of four quarters that breaks as bonded; a level fractures each into three.
Project bondedQuarters() {
    Project project = projectOf(
        unitSquare(), PlacedSeeds{{{0, {0.25, 0.25}}, {1, {0.75, 0.25}}, {2, {0.75, 0.75}}, {3, {0.25, 0.75}}}});
    project.assets[0].levels = {{.pattern = {{{.id = 5, .randomSeed = 5, .parameters = UniformScatter{.count = 3}}}}}};
    project.assets[0].breakAs = BreakAs::Bonded;
    return project;
}

struct BondBench : CanvasBench {
    explicit BondBench(CanvasToolKind kind = CanvasToolKind::AnchorBrush, Project project = bondedQuarters())
        : CanvasBench(std::move(project)) {
        canvas.setTool(kind);
        waitForBake();
    }
    void waitForBake() {
        QVERIFY(QTest::qWaitFor(
            [&] {
                const auto baked = bakes.find(asset().id);
                return baked && baked->bake && *baked->asset == asset();
            },
            kPatience));
    }
    const std::vector<BondStroke>& strokes() const { return asset().bonding.strokes; }
    std::vector<std::uint32_t> anchored() const { return anchoredFragments(asset(), *bakes.find(asset().id)->bake, 0); }
    QUndoStack& stack() { return document.undoStack(); }
    BondBrushTool& tool() { return canvas.bondBrushTool(); }
    double radius() { return bondPainter.radiusPixels() / canvas.view().scale; }
};

bool areNear(Vec2 a, Vec2 b, double tolerance) { return glm::length(a - b) <= tolerance; }

}  // namespace

class BondBrushToolTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void strokeIsOneUndoStepInThePlane() {
        BondBench bench;
        const Vec2 from = bench.metres({0.25, 0.25}), to = bench.metres({0.75, 0.25});
        bench.drag(from, to);
        QCOMPARE(bench.strokes().size(), std::size_t{1});
        const BondStroke& stroke = bench.strokes()[0];
        QCOMPARE(stroke.brush, BondBrush::Anchor);
        QVERIFY(!stroke.isErasing);
        QCOMPARE(stroke.strength, 1.0);
        QCOMPARE(stroke.radius, bench.radius());
        QCOMPARE(stroke.points.size(), std::size_t{2});
        QVERIFY(areNear(stroke.points[0], from, 1e-9) && areNear(stroke.points[1], to, 1e-9));
        bench.waitForBake();
        QCOMPARE(bench.anchored(), (std::vector<std::uint32_t>{0, 1}));
        QCOMPARE(bench.stack().count(), 1);
        QCOMPARE(bench.stack().undoText(), QString("Paint Anchors"));
        bench.stack().undo();
        QVERIFY(bench.strokes().empty());
        bench.stack().redo();
        QCOMPARE(bench.strokes().size(), std::size_t{1});
    }
    void clickPaintsAPoint() {
        BondBench bench(CanvasToolKind::NeverBreaksBrush);
        bench.click({0.75, 0.75});
        QCOMPARE(bench.strokes().size(), std::size_t{1});
        QCOMPARE(bench.strokes()[0].brush, BondBrush::NeverBreaks);
        QCOMPARE(bench.strokes()[0].points, (std::vector<Vec2>{bench.metres({0.75, 0.75})}));
    }
    void pointsNearTheLineAreLeftOut() {
        BondBench bench;
        const double off = 0.2 * bench.radius();
        bench.press({0.1, 0.5});
        for (double x = 0.12; x < 0.9; x += 0.04) {
            bench.moveTo({x, 0.5 + off});
            bench.moveTo({x + 0.02, 0.5});
        }
        bench.release({0.9, 0.5});
        QVERIFY2(bench.strokes()[0].points.size() <= 3, qPrintable(QString::number(bench.strokes()[0].points.size())));
        bench.press({0.1, 0.5});
        bench.moveTo({0.5, 0.5 + 2.0 * bench.radius()});
        bench.moveTo({0.9, 0.5});
        bench.release({0.9, 0.5});
        QCOMPARE(bench.strokes()[1].points.size(), std::size_t{3});
    }
    void shiftErases() {
        BondBench bench;
        bench.drag({0.25, 0.25}, {0.75, 0.25});
        bench.click({0.75, 0.25}, Qt::ShiftModifier);
        bench.waitForBake();
        QVERIFY(bench.strokes()[1].isErasing);
        QCOMPARE(bench.anchored(), (std::vector<std::uint32_t>{0}));
        QCOMPARE(bench.stack().undoText(), QString("Erase Anchors"));
    }
    void keySwitchesToErasing() {
        BondBench bench;
        bench.key(Qt::Key_X);
        QVERIFY(bench.tool().hint().startsWith("Drag: erase"));
        bench.click({0.25, 0.25}, Qt::ShiftModifier);  // inverted
        bench.click({0.25, 0.25});
        QCOMPARE(bench.strokes().size(), std::size_t{2});
        QVERIFY(!bench.strokes()[0].isErasing && bench.strokes()[1].isErasing);
    }
    void nothingIsErasedWithoutStrokesOfTheBrush() {
        BondBench bench;
        bench.click({0.25, 0.25});
        bench.canvas.setTool(CanvasToolKind::NeverBreaksBrush);
        QSignalSpy messages(&bench.canvas, &PatternCanvas::statusMessage);
        bench.click({0.25, 0.25}, Qt::ShiftModifier);
        QCOMPARE(bench.strokes().size(), std::size_t{1});
        QVERIFY(messages[0][0].toString().contains("no strokes of this brush"));
    }
    void escapeCancelsTheStroke() {
        BondBench bench;
        bench.press({0.25, 0.25});
        bench.moveTo({0.75, 0.25});
        bench.key(Qt::Key_Escape);
        bench.release({0.75, 0.25});
        QVERIFY(bench.strokes().empty());
        QCOMPARE(bench.stack().count(), 0);
    }
    void otherEditEndsAStroke() {
        BondBench bench;
        bench.press({0.25, 0.25});
        bench.renameAsset("renamed");
        bench.moveTo({0.75, 0.25});
        bench.release({0.75, 0.25});
        QVERIFY(bench.strokes().empty());
        QCOMPARE(bench.asset().name, std::string("renamed"));
    }
    void undoDuringAStrokeDropsIt() {
        BondBench bench;
        bench.click({0.25, 0.25});
        bench.press({0.75, 0.25});
        bench.stack().undo();
        bench.release({0.75, 0.25});
        QVERIFY(bench.strokes().empty());
        QVERIFY(bench.stack().canRedo());
    }
    void strengthIsThatOfTheBrush() {
        BondBench bench(CanvasToolKind::StrengthBrush);
        QCOMPARE(bench.bondPainter.settings().strength, 2.0);
        bench.click({0.5, 0.25});
        bench.key(Qt::Key_Period);
        bench.click({0.5, 0.75});
        bench.bondPainter.setStrength(0.3);
        bench.key(Qt::Key_Comma);
        bench.click({0.5, 0.75});
        QCOMPARE(bench.strokes()[0].strength, 2.0);
        QCOMPARE(bench.strokes()[1].strength, 3.0);
        QCOMPARE(bench.strokes()[2].strength, 0.2);
        QCOMPARE(strengthAt(bench.asset(), bench.metres({0.5, 0.25})), 2.0);
        QVERIFY(bench.tool().hint().contains("0.2 times"));
    }
    void strengthStaysInRange() {
        BondBench bench(CanvasToolKind::StrengthBrush);
        for (int k = 0; k < 12; ++k) bench.key(Qt::Key_Period);
        QCOMPARE(bench.bondPainter.settings().strength, 10.0);
        for (int k = 0; k < 12; ++k) bench.key(Qt::Key_Comma);
        QCOMPARE(bench.bondPainter.settings().strength, 0.0);
        QMenu menu;
        bench.tool().fillMenu(menu, {});
        const QList<QAction*> factors = menu.findChild<QMenu*>()->actions();
        const auto checked = std::ranges::find_if(factors, [](const QAction* factor) { return factor->isChecked(); });
        QCOMPARE((*checked)->text(), QString("0"));
        factors.back()->trigger();
        QCOMPARE(bench.bondPainter.settings().strength, 10.0);
    }
    void anyStrengthCanBeTyped() {
        BondBench bench(CanvasToolKind::StrengthBrush);
        QMenu menu;
        bench.tool().fillMenu(menu, {});
        auto& field = *menu.findChild<NumberField*>();
        QCOMPARE(field.value(), 2.0);
        field.selectAll();
        QTest::keyClicks(&field, "1.25");
        QVERIFY(field.commit());
        QCOMPARE(bench.bondPainter.settings().strength, 1.25);
        field.selectAll();
        QTest::keyClicks(&field, "11");
        QVERIFY(!field.commit());
        QCOMPARE(bench.bondPainter.settings().strength, 1.25);
    }
    void bracketsAndWheelChangeTheSize() {
        BondBench bench;
        const double before = bench.bondPainter.radiusPixels();
        bench.key(Qt::Key_BracketRight);
        const double larger = bench.bondPainter.radiusPixels();
        QVERIFY(larger > before);
        const QPointF middle = QRectF(bench.canvas.rect()).center();
        QWheelEvent event(middle, middle, {}, {0, -120}, Qt::NoButton, Qt::ControlModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(&bench.canvas, &event);
        QCOMPARE(bench.bondPainter.radiusPixels(), before);
        QVERIFY(bench.tool().overridesShortcut(Qt::Key_BracketLeft));
        QVERIFY(!bench.tool().overridesShortcut(Qt::Key_Comma));  // the factor is of the strength brush
    }
    void wholeAssetsAreNotPainted() {
        Project project = bondedQuarters();
        project.assets[0].breakAs = BreakAs::Whole;
        BondBench bench(CanvasToolKind::AnchorBrush, std::move(project));
        QVERIFY(bench.canvas.hint().contains("breaks whole"));
        QSignalSpy messages(&bench.canvas, &PatternCanvas::statusMessage);
        bench.click({0.25, 0.25});
        QVERIFY(bench.strokes().empty());
        QVERIFY(messages[0][0].toString().contains("breaks whole"));
    }
    void marksFollowTheStrokeBeforeItEnds() {
        BondBench bench;
        const QImage before = bench.canvas.picture({640, 480});
        const auto at = [&](const QImage& image, Vec2 point) { return image.pixelColor(bench.pixels(point)); };
        bench.press({0.1, 0.1});
        bench.moveTo({0.1, 0.15});
        const QImage during = bench.canvas.picture({640, 480});
        QVERIFY(at(during, {0.4, 0.1}) != at(before, {0.4, 0.1}));  // the quarter, beyond the brush
        QCOMPARE(at(during, {0.6, 0.1}), at(before, {0.6, 0.1}));
        bench.key(Qt::Key_Escape);
        QCOMPARE(bench.canvas.picture({640, 480}), before);
    }
    void inAFragmentStrokesAreInThePlaneOfTheAsset() {
        BondBench bench;
        enterFragment(bench.selection, "3.2");
        QVERIFY(QTest::qWaitFor(
            [&] {
                const DrawablePattern* shown = bench.canvas.displayedPattern();
                return shown && shown->baked().parent == bench.selection.enteredFragment();
            },
            kPatience));
        bench.click({0.0, 0.0});  // its centre of mass
        QCOMPARE(bench.strokes().size(), std::size_t{1});
        QVERIFY(areNear(bench.strokes()[0].points[0], {0.75, 0.75}, 1.0 / bench.canvas.view().scale));
    }
};

RUBBLE_TEST_WITH(BondBrushToolTest, QApplication)
#include "BondBrushToolTest.moc"
