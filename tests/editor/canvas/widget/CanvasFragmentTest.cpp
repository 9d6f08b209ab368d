// Tests editor/canvas/widget/PatternCanvas.cpp and the tools in an entered fragment.
#include "core/asset/bake/FragmentLookup.h"
#include "core/asset/checks/VerifyProject.h"
#include "core/io/project/ProjectFile.h"
#include "editor/canvas/tools/OutlineTool.h"
#include "editor/document/EnteredFragment.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/RandomAssets.h"
#include "tests/support/editor/Canvas.h"

#include <QSignalSpy>
#include <QTest>

using namespace rubble;

namespace {

/// A square of four quarters; a level fractures each into three pieces.
Project quarters() {
    Project project = projectOf(
        unitSquare(), PlacedSeeds{{{0, {0.25, 0.25}}, {1, {0.75, 0.25}}, {2, {0.75, 0.75}}, {3, {0.25, 0.75}}}});
    project.assets[0].levels = {{.pattern = {{{.id = 5, .randomSeed = 5, .parameters = UniformScatter{.count = 3}}}}}};
    return project;
}

/// A canvas that can enter fragments.
struct FragmentBench : CanvasBench {
    explicit FragmentBench(Project project = quarters()) : CanvasBench(std::move(project)) { settleAll(); }

    bool isBaked() const {
        const auto baked = bakes.find(asset().id);
        return baked && baked->bake && *baked->asset == asset();
    }
    bool isShown() const {
        const DrawablePattern* shown = canvas.displayedPattern();
        if (!shown || shown->baked().parent != selection.enteredFragment() || !isBaked()) return false;
        return selection.enteredFragment().empty() || *shown->baked().asset == *fragment();
    }
    std::shared_ptr<const Asset> fragment() const {
        const auto solid = fragmentSolid(bakes, asset().id, selection.enteredFragment());
        if (!solid) return nullptr;
        return std::make_shared<const Asset>(fragmentAsAsset(asset(), selection.enteredFragment(), solid->prism));
    }
    /// Waits until the canvas shows the bake of the current document.
    void settleAll() {
        settle();
        QVERIFY(QTest::qWaitFor([&] { return isShown(); }, kPatience));
        QCoreApplication::processEvents();
    }
    void enter(const FragmentPath& path) {
        enterFragment(selection, path);
        settleAll();
    }
    const Bake& bake() const { return *bakes.find(asset().id)->bake; }
    std::string text() const { return projectText(document.project()); }
    void doubleClick(Vec2 at) {
        click(at);
        QTest::mouseDClick(&canvas, Qt::LeftButton, {}, pixels(at));
        QTest::mouseRelease(&canvas, Qt::LeftButton, {}, pixels(at));
        settleAll();
    }
    /// A point of the displayed outline without a seed nearby.
    Vec2 freePlace() const {
        const Box2 box = boundsOf(fragment()->prism().outline.outer);
        for (double x = 0.3; x < 0.7; x += 0.02) {
            const Vec2 at = box.min + Vec2(x, 0.4) * box.size();
            if (canvas.displayedPattern()->nearestSeed(at, 0.04) == kNone) return at;
        }
        return {};
    }
};

bool isSame(const Partition& a, const Partition& b) {
    return a.origin == b.origin && a.points == b.points && a.corners == b.corners && a.neighbours == b.neighbours &&
           a.cornersOfRing == b.cornersOfRing && a.ringsOfPiece == b.ringsOfPiece && a.seedOfPiece == b.seedOfPiece;
}

}  // namespace

class CanvasFragmentTest : public QObject {
    Q_OBJECT
private slots:
    void displayedPatternEqualsTheBake() {
        Random random(4711);
        for (int kind = 0; kind < 9; ++kind) {
            Project project = test::randomAsset(random, kind);
            Asset& asset = project.assets[0];
            asset.levels = {{.pattern = {{{.id = 90, .randomSeed = 8, .parameters = UniformScatter{.count = 4}}}}},
                            {.pattern = {{{.id = 91, .randomSeed = 9, .parameters = BlueNoise{}}}}}};
            if (kind % 2 == 1) asset.shaping.gap = 0.002;
            if (kind % 3 == 1) asset.shaping.smallPieces = {SmallPieceRule::Merge, PieceMeasure::FractionOfWhole, 0.05};
            project.nextId = 100;
            FragmentBench bench(project);
            const std::shared_ptr<const Bake> baked = bench.bakes.find(asset.id)->bake;
            for (const BakedFracture& fracture : baked->fractures) {
                if (fracture.parent == kNone) continue;
                bench.enter(baked->fragmentPath(fracture.parent));
                const BakedPattern& shown = bench.canvas.displayedPattern()->baked();
                QVERIFY(isSame(shown.partition, fracture.fragments.extruded()->partition));
                QVERIFY(shown.seeds.ids == fracture.seeds.ids && shown.seeds.positions == fracture.seeds.positions);
                for (std::uint32_t k = 0; k < fracture.fragments.count(); ++k) {
                    QCOMPARE(bench.canvas.displayedPattern()->fragmentId(fracture.fragments[k].extruded()->piece()),
                             baked->fragmentId(fracture.first + k));
                }
            }
        }
    }
    void doubleClickEntersWithoutAnEdit() {
        FragmentBench bench;
        const std::string before = bench.text();
        bench.doubleClick({0.6, 0.4});
        QCOMPARE(bench.selection.enteredFragment(), FragmentPath("3.1"));
        QCOMPARE(bench.text(), before);
        QCOMPARE(bench.document.undoStack().count(), 0);
        QCOMPARE(bench.document.project().nextId, quarters().nextId);
        // The whole fragment is visible, in its own frame.
        const Box2 shown = bench.canvas.view().visibleBox();
        QVERIFY(shown.min.x < -0.25 && shown.max.x > 0.25 && shown.max.x < 0.6);
    }
    void doubleClickOfThePlacingToolPlacesOneSeed() {
        Project project = quarters();
        project.assets[0].fragmentLevels = {{"3.1", std::nullopt}};  // kept whole
        FragmentBench bench(project);
        const Vec2 at{0.6, 0.4};
        bench.canvas.setTool(CanvasToolKind::PlaceSeeds);
        bench.click(at);
        QTest::mouseDClick(&bench.canvas, Qt::LeftButton, {}, bench.pixels(at));
        QTest::mouseRelease(&bench.canvas, Qt::LeftButton, {}, bench.pixels(at));
        bench.settleAll();
        QVERIFY(bench.selection.enteredFragment().empty());
        QCOMPARE(bench.document.undoStack().count(), 1);
    }
    void seedPlacedInAFragmentAffectsItAlone() {
        FragmentBench bench;
        const std::string before = bench.text();
        const std::shared_ptr<const Bake> was = bench.bakes.find(2)->bake;
        QSignalSpy messages(&bench.canvas, &PatternCanvas::statusMessage);
        bench.enter("3.2");
        const Vec2 at = bench.freePlace();
        bench.canvas.setTool(CanvasToolKind::PlaceSeeds);
        bench.click(at);
        bench.settleAll();
        QCOMPARE(messages.count(), 1);
        QVERIFY(messages[0][0].toString().startsWith("Fragment 3.2 now has its own pattern"));
        QCOMPARE(bench.asset().fragmentLevels.size(), std::size_t{1});
        QCOMPARE(bench.asset().fragmentLevels[0].fragment, FragmentPath("3.2"));
        const Pattern& own = bench.asset().fragmentLevels[0].level->pattern;
        QCOMPARE(own.layers.size(), std::size_t{2});
        QCOMPARE(own.layers[0].id, 5u);
        QVERIFY(std::get<PlacedSeeds>(own.layers[1].parameters).seeds ==
                (std::vector<PlacedSeeds::Seed>{{0, bench.metres(at)}}));
        QVERIFY(bench.asset().levels == quarters().assets[0].levels);
        QVERIFY(!verifyProject(bench.document.project()));
        for (const BakedFracture& fracture : was->fractures) {
            const BakedFracture& now = *bench.bake().fractureOf(fracture.parent);
            const bool isIt = fracture.parent != kNone && was->fragmentId(fracture.parent) == "2/3.2";
            QCOMPARE(isSame(fracture.fragments.extruded()->partition, now.fragments.extruded()->partition), !isIt);
        }

        bench.document.undoStack().undo();
        bench.settleAll();
        QCOMPARE(bench.text(), before);
        QCOMPARE(bench.selection.enteredFragment(), FragmentPath("3.2"));
        bench.document.undoStack().redo();
        QCOMPARE(messages.count(), 1);  // redo emits no message
    }
    void draggedLevelSeedMovesInOneStep() {
        FragmentBench bench;
        bench.enter("3.2");
        const SeedId seed = bench.seedId(0);
        const Vec2 from = bench.seedAt(0);
        bench.drag(from, 0.6 * from);
        bench.settleAll();
        QCOMPARE(bench.document.undoStack().count(), 1);
        QCOMPARE(bench.asset().fragmentLevels.size(), std::size_t{1});
        const auto& overrides = bench.asset().fragmentLevels[0].level->pattern.layers[0].overrides;
        QCOMPARE(overrides.size(), std::size_t{1});
        QCOMPARE(overrides[0].index, seed.index);
        QVERIFY((bench.selection.fragments() == FragmentSelection{{seed}, std::nullopt, "3.2"}));
        QVERIFY(isSame(bench.canvas.displayedPattern()->partition(),
                       bench.bake().fractureOf(*fragmentAt(bench.bake(), "3.2"))->fragments.extruded()->partition));
        bench.key(Qt::Key_Left);
        bench.key(Qt::Key_Delete);
        bench.settleAll();
        QVERIFY(bench.asset().fragmentLevels[0].level->pattern.layers[0].overrides[0].isDeleted);
        QCOMPARE(bench.canvas.displayedPattern()->seeds().ids.size(), std::size_t{2});
    }
    void cancelledDragLeavesNoEdit() {
        FragmentBench bench;
        const std::string before = bench.text();
        bench.enter("3.2");
        const Vec2 from = bench.seedAt(0);
        bench.press(from);
        bench.moveTo(0.5 * from);
        bench.moveTo(0.6 * from);
        QVERIFY(!bench.asset().fragmentLevels.empty());
        QTest::keyClick(&bench.canvas, Qt::Key_Escape);
        bench.release(from);
        QCOMPARE(bench.text(), before);
        QCOMPARE(bench.document.undoStack().count(), 0);
        QCOMPARE(bench.selection.enteredFragment(), FragmentPath("3.2"));
    }
    void cracksAndPaintBelongToTheFragment() {
        FragmentBench bench;
        bench.enter("3.0");
        const Vec2 corner = boundsOf(bench.fragment()->prism().outline.outer).max;
        bench.canvas.setTool(CanvasToolKind::CrackLines);
        bench.drag({-1.1 * corner.x, 0.0}, {1.1 * corner.x, 0.01});
        bench.settleAll();
        bench.canvas.setTool(CanvasToolKind::Brush);
        bench.drag({-0.1, 0.1}, {0.1, 0.1});
        bench.settleAll();
        QCOMPARE(bench.document.undoStack().count(), 2);
        QVERIFY(bench.asset().pattern == quarters().assets[0].pattern);
        const auto& layers = bench.asset().fragmentLevels[0].level->pattern.layers;
        QCOMPARE(layers.size(), std::size_t{3});
        QVERIFY(std::holds_alternative<CrackLines>(layers[1].parameters));
        QVERIFY(std::get<DensityImage>(layers[2].parameters).image);
        QVERIFY(!verifyProject(bench.document.project()));
    }
    void fragmentOutlineCannotBeEdited() {
        FragmentBench bench;
        bench.enter("3.0");
        const std::string before = bench.text();
        bench.canvas.setTool(CanvasToolKind::Outline);
        QSignalSpy messages(&bench.canvas, &PatternCanvas::statusMessage);
        const Vec2 corner = bench.fragment()->prism().outline.outer[0];
        bench.drag(corner, 0.8 * corner);
        QCOMPARE(messages.count(), 1);
        QVERIFY(messages[0][0].toString().startsWith("The outline of a fragment"));
        QCOMPARE(bench.canvas.hint(), messages[0][0].toString());
        bench.key(Qt::Key_Insert);
        bench.key(Qt::Key_Delete);
        QCOMPARE(bench.text(), before);
        bench.key(Qt::Key_Escape);
        QVERIFY(bench.selection.enteredFragment().empty());
    }
    void gapsShowTheBackground() {
        Project project = quarters();
        project.assets[0].shaping.gap = 0.06;
        FragmentBench bench(project);
        QCoreApplication::processEvents();
        const QPoint middle = bench.pixels({0.5, 0.25});  // on the edge between two quarters
        const QColor background = canvasColours(bench.canvas.palette()).background;
        CanvasOverlays overlays = bench.canvas.overlays();
        overlays.hasGrid = overlays.hasLegend = false;
        bench.canvas.setOverlays(overlays);
        const auto pixel = [&] { return bench.canvas.grab().toImage().pixelColor(middle + QPoint(3, 0)); };
        QCOMPARE(pixel(), background);
        Asset whole = bench.asset();
        whole.shaping.gap = 0.0;
        bench.document.push(modify("No Gap", whole));
        bench.settleAll();
        QVERIFY(pixel() != background);
    }
    void deeperLevelsAreShownOnDemand() {
        FragmentBench bench;
        const QImage without = bench.canvas.grab().toImage();
        CanvasOverlays overlays = bench.canvas.overlays();
        overlays.hasDeeperLevels = true;
        bench.canvas.setOverlays(overlays);
        QVERIFY(bench.canvas.grab().toImage() != without);
        overlays.hasDeeperLevels = false;
        bench.canvas.setOverlays(overlays);
        QCOMPARE(bench.canvas.grab().toImage(), without);
    }
    void boxAndLassoSelectDeeperFragments() {
        FragmentBench bench;
        bench.enter("3.3");
        const Box2 box = bench.canvas.view().visibleBox();
        bench.drag(0.95 * box.min, 0.95 * box.max, Qt::AltModifier);  // a lasso without width
        QVERIFY(bench.selection.fragments().isEmpty());
        bench.drag(0.9 * box.min, 0.9 * box.max);
        QCOMPARE(bench.selection.seeds().size(), std::size_t{3});
        const FragmentSet selected = fragmentsOf(bench.selection.fragments(), bench.bake());
        const BakedFracture& fracture = *bench.bake().fractureOf(*fragmentAt(bench.bake(), "3.3"));
        for (std::uint32_t k = 0; k < selected.size(); ++k) {
            QCOMPARE(selected[k], k >= fracture.first && k < fracture.first + fracture.fragments.count());
        }
        bench.canvas.seedTool().invertSelection();
        QVERIFY(bench.selection.fragments().isEmpty());
        bench.canvas.seedTool().selectAll();
        QCOMPARE(fragmentsOf(bench.selection.fragments(), bench.bake()), selected);
    }
    void escapeClearsTheSelectionThenExits() {
        FragmentBench bench;
        bench.enter("3.3");
        bench.click(bench.seedAt(1));
        QCOMPARE(bench.selection.seeds().size(), std::size_t{1});
        QTest::keyClick(&bench.canvas, Qt::Key_Escape);
        QVERIFY(bench.selection.fragments().isEmpty());
        QCOMPARE(bench.selection.enteredFragment(), FragmentPath("3.3"));
        QTest::keyClick(&bench.canvas, Qt::Key_Escape);
        QVERIFY(bench.selection.enteredFragment().empty());
        QVERIFY((bench.selection.seeds() == Selection::Seeds{{3, 3}}));
        bench.settleAll();
        QVERIFY(bench.canvas.displayedPattern()->baked().parent.empty());
    }
    void hiddenFragmentsAreHatched() {
        FragmentBench bench;
        bench.enter("3.3");
        CanvasOverlays overlays = bench.canvas.overlays();
        overlays.hasLegend = false;  // it has a row for hidden fragments
        bench.canvas.setOverlays(overlays);
        const QImage before = bench.canvas.grab().toImage();
        bench.selection.setHidden({{{3, 3}}, std::nullopt});  // with all of its children
        QVERIFY(bench.canvas.grab().toImage() != before);
        bench.selection.setHidden({{{3, 2}}, std::nullopt});
        QCOMPARE(bench.canvas.grab().toImage(), before);
    }
};

RUBBLE_TEST_WITH(CanvasFragmentTest, QApplication)
#include "CanvasFragmentTest.moc"
