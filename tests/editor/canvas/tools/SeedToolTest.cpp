// Tests editor/canvas/tools/SeedTool.cpp, editor/canvas/tools/CanvasTool.cpp and
// editor/canvas/tools/PieceSelection.cpp.
#include "core/asset/checks/VerifyProject.h"
#include "core/base/Random.h"
#include "core/io/project/ProjectFile.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Canvas.h"

#include <QMouseEvent>
#include <QTest>

using namespace rubble;

namespace {

PlacedSeeds fourSeeds() { return {{{0, {0.25, 0.25}}, {1, {0.75, 0.25}}, {2, {0.75, 0.75}}, {3, {0.25, 0.75}}}}; }

const std::vector<PlacedSeeds::Seed>& placedSeeds(const CanvasBench& bench, std::size_t layer = 0) {
    return std::get<PlacedSeeds>(bench.asset().pattern.layers[layer].parameters).seeds;
}

/// A square with one seed on the right of a crack that halves it.
Project halves() {
    Project project = projectOf(unitSquare(), PlacedSeeds{{{0, {0.55, 0.5}}}});
    const CrackLines crack{{{0, {{0.5, -0.1}, {0.5, 1.1}}}}};
    project.assets[0].pattern.layers.push_back({.id = 4, .parameters = crack});
    return project;
}

/// The identifiers of the selected fragments, once they are baked.
QStringList selectedIds(const CanvasBench& bench) {
    const auto isBaked = [&] { return bench.bakes.areCurrent(bench.document.project()); };
    if (!QTest::qWaitFor(isBaked, kPatience)) return {"not baked"};
    const Bake& bake = *bench.bakes.find(2)->bake;
    const FragmentSet set = fragmentsOf(bench.selection.fragments(), bake);
    QStringList ids;
    for (std::uint32_t k = 0; k < set.size(); ++k) {
        if (set[k]) ids << QString::fromStdString(bake.fragmentId(k));
    }
    ids.sort();
    return ids;
}

}  // namespace

class SeedToolTest : public QObject {
    Q_OBJECT
private slots:
    void clickSelectsTheFragmentUnderThePointer() {
        CanvasBench bench(projectOf(unitSquare(), fourSeeds()));
        bench.click({0.6, 0.4});
        QVERIFY((bench.selection.seeds() == Selection::Seeds{{3, 1}}));
        bench.click({0.4, 0.4});
        QVERIFY((bench.selection.seeds() == Selection::Seeds{{3, 0}}));
        bench.click({0.4, 0.6}, Qt::ControlModifier);
        QVERIFY((bench.selection.seeds() == Selection::Seeds{{3, 0}, {3, 3}}));
        bench.click({1.05, 0.5});  // outside
        QVERIFY(bench.selection.seeds().empty());
        QCOMPARE(bench.document.undoStack().count(), 0);
    }
    void clickSelectsOneFragmentOfACellWithSeveral() {
        CanvasBench bench(halves());
        bench.click({0.2, 0.5});
        QCOMPARE(selectedIds(bench), QStringList{"2/3.0.0"});
        QVERIFY(bench.canvas.hint().startsWith("1 fragment(s) selected"));
        bench.click({0.55, 0.5});  // at the seed, which is in the other half
        QCOMPARE(selectedIds(bench), QStringList{"2/3.0.1"});
        bench.click({0.2, 0.5}, Qt::ControlModifier);
        QCOMPARE(selectedIds(bench), (QStringList{"2/3.0.0", "2/3.0.1"}));
        bench.click({0.55, 0.5}, Qt::ControlModifier);
        QCOMPARE(selectedIds(bench), QStringList{"2/3.0.0"});
    }
    void seedsAreSelectedWithAltOrThePlacingTool() {
        CanvasBench bench(halves());
        bench.click({0.2, 0.5}, Qt::AltModifier);
        QVERIFY((bench.selection.fragments() == FragmentSelection{.seeds = {{3, 0}}}));
        QCOMPARE(selectedIds(bench).size(), 2);
        bench.selection.setSeeds({});
        bench.canvas.setTool(CanvasToolKind::PlaceSeeds);
        bench.click({0.55, 0.5});
        QVERIFY((bench.selection.fragments() == FragmentSelection{.seeds = {{3, 0}}}));
        QVERIFY(bench.canvas.hint().startsWith("1 seed(s) selected"));
    }
    void boxAndKeysSelectFragments() {
        CanvasBench bench(halves());
        bench.drag({0.1, 0.9}, {0.4, 0.1});  // around the centre of the left half
        QCOMPARE(selectedIds(bench), QStringList{"2/3.0.0"});
        bench.key(Qt::Key_PageDown);
        QCOMPARE(selectedIds(bench), QStringList{"2/3.0.1"});
        bench.key(Qt::Key_PageDown);
        QCOMPARE(selectedIds(bench), QStringList{"2/3.0.0"});
        bench.canvas.seedTool().invertSelection();
        QCOMPARE(selectedIds(bench), QStringList{"2/3.0.1"});
        bench.canvas.seedTool().selectNeighbours();
        QCOMPARE(selectedIds(bench).size(), 2);
    }
    void clickSelectsOneOfTheFragmentsBetweenRadialCracks() {
        CanvasBench bench(projectOf(unitSquare(), RadialCracks{.centre = {0.5, 0.5}, .radius = 0.4}));
        const DrawablePattern& pattern = *bench.canvas.displayedPattern();
        QVERIFY(pattern.partition().pieceCount() > 60u);
        const std::uint32_t corner = pattern.pieceAt({0.03, 0.03});
        bench.click({0.03, 0.03});
        QCOMPARE(selectedIds(bench), QStringList{QString::fromStdString(pattern.fragmentId(corner))});
    }
    void dragOfASeedInAnyOfItsFragmentsMovesIt() {
        CanvasBench bench(halves());
        bench.click({0.2, 0.5});
        bench.drag({0.55, 0.5}, {0.6, 0.6});
        QCOMPARE(bench.document.undoStack().count(), 1);
        QVERIFY(placedSeeds(bench)[0].position.y > 0.55);
    }
    void clickOfThePlacingToolPlacesASeed() {
        CanvasBench bench(projectOf(unitSquare(), fourSeeds()));
        bench.canvas.setTool(CanvasToolKind::PlaceSeeds);
        bench.click({0.5, 0.5});
        QCOMPARE(placedSeeds(bench).size(), std::size_t{5});
        QVERIFY(placedSeeds(bench)[4] == (PlacedSeeds::Seed{4, bench.metres({0.5, 0.5})}));
        QCOMPARE(bench.canvas.displayedPattern()->partition().pieceCount(), 5u);
    }
    void clickAddsALayerInTheSameStep() {
        CanvasBench bench(projectOf(unitSquare(), UniformScatter{.count = 2}));
        const Project before = bench.document.project();
        Vec2 at{0.5, 0.5};
        while (bench.canvas.displayedPattern()->nearestSeed(at, 0.1) != kNone) at = 0.9 * at;
        bench.canvas.setTool(CanvasToolKind::PlaceSeeds);
        bench.click(at);
        QCOMPARE(bench.asset().pattern.layers.size(), std::size_t{2});
        QVERIFY(placedSeeds(bench, 1) == (std::vector<PlacedSeeds::Seed>{{0, bench.metres(at)}}));
        QVERIFY(!verifyProject(bench.document.project()));
        QCOMPARE(bench.document.undoStack().count(), 1);
        bench.document.undoStack().undo();
        QVERIFY(bench.document.project() == before);
    }
    void seedDragIsOneUndoStep() {
        CanvasBench bench(projectOf(unitSquare(), fourSeeds()));
        bench.drag({0.25, 0.25}, {0.4, 0.35});
        QCOMPARE(bench.document.undoStack().count(), 1);
        const Vec2 by = bench.metres({0.4, 0.35}) - bench.metres({0.25, 0.25});
        const Vec2 off = placedSeeds(bench)[0].position - (Vec2(0.25, 0.25) + by);
        QVERIFY(std::abs(off.x) < 1e-12 && std::abs(off.y) < 1e-12);
        bench.document.undoStack().undo();
        QVERIFY(placedSeeds(bench) == fourSeeds().seeds);
    }
    void dragMovesThePressedSeedIfABakeEndsMeanwhile() {
        CanvasBench bench(projectOf(unitSquare(), fourSeeds()));
        Asset asset = bench.asset();
        asset.pattern.layers[0].parameters = PlacedSeeds{{{2, {0.75, 0.75}}, {3, {0.25, 0.75}}}};
        const QPointF at(bench.pixels({0.25, 0.75}));
        QMouseEvent press(QEvent::MouseButtonPress, at, bench.canvas.mapToGlobal(at), Qt::LeftButton, Qt::LeftButton,
                          Qt::NoModifier);
        bench.document.push(modify("Delete Seeds", asset));
        QCoreApplication::sendEvent(&bench.canvas, &press);  // in the old pattern
        QCOMPARE(bench.canvas.displayedPattern()->seeds().ids.size(), std::size_t{4});
        bench.settle();
        bench.moveTo({0.4, 0.6});
        bench.release({0.4, 0.6});
        QVERIFY((placedSeeds(bench)[0] == PlacedSeeds::Seed{2, {0.75, 0.75}}));
        QVERIFY(placedSeeds(bench)[1].position.x > 0.3);
    }
    void layerCentreDragIsOneUndoStep() {
        CanvasBench bench(projectOf(unitSquare(), RadialPattern{.centre = {0.5, 0.5}, .radius = 0.6}));
        const Project before = bench.document.project();
        const auto centre = [&] { return std::get<RadialPattern>(bench.asset().pattern.layers[0].parameters).centre; };
        bench.drag({0.5, 0.5}, {0.3, 0.4});
        QCOMPARE(bench.document.undoStack().count(), 1);
        QVERIFY(centre() == bench.metres({0.3, 0.4}));
        QVERIFY(bench.selection.seeds().empty());
        QVERIFY(bench.seedAt(0) == centre());  // the centre's seed moves along: the layer was evaluated again
        bench.press({0.3, 0.4});
        QVERIFY(bench.canvas.hint().contains("Esc"));
        bench.moveTo({0.7, 0.7});
        bench.key(Qt::Key_Escape);
        bench.release({0.7, 0.7});
        QVERIFY(centre() == bench.metres({0.3, 0.4}));
        while (bench.document.undoStack().canUndo()) bench.document.undoStack().undo();
        QVERIFY(bench.document.project() == before);
    }
    void clickOnALayerCentreDoesNothing() {
        CanvasBench bench(projectOf(unitSquare(), ImpactScatter{.centre = {0.5, 0.5}, .count = 5}));
        const Project before = bench.document.project();
        bench.click({0.5, 0.5});
        QVERIFY(bench.document.project() == before);
        QCOMPARE(bench.document.undoStack().count(), 0);
    }
    void undoEndsADrag() {
        CanvasBench bench(projectOf(unitSquare(), fourSeeds()));
        const Project before = bench.document.project();
        bench.press({0.25, 0.25});
        bench.moveTo({0.4, 0.35});
        QVERIFY(bench.document.project() != before);
        bench.document.undoStack().undo();
        bench.moveTo({0.5, 0.5});
        bench.release({0.5, 0.5});
        QVERIFY(bench.document.project() == before);
        QVERIFY(bench.document.undoStack().canRedo());
    }
    void otherEditEndsADrag() {
        CanvasBench bench(projectOf(unitSquare(), fourSeeds()));
        bench.press({0.25, 0.25});
        bench.moveTo({0.4, 0.35});
        bench.renameAsset("renamed");
        const Project before = bench.document.project();
        bench.moveTo({0.5, 0.5});
        bench.release({0.5, 0.5});
        QVERIFY(bench.document.project() == before);
        QCOMPARE(bench.asset().name, std::string("renamed"));
    }
    void escapeCancelsADrag() {
        CanvasBench bench(projectOf(unitSquare(), UniformScatter{.count = 5}));
        const Vec2 seed = bench.seedAt(2);
        bench.press(seed);
        bench.moveTo(seed + Vec2(0.1, 0.1));
        QVERIFY(!bench.asset().pattern.layers[0].overrides.empty());
        bench.key(Qt::Key_Escape);
        bench.moveTo(seed + Vec2(0.2, 0.1));
        bench.release(seed);
        QVERIFY(bench.asset().pattern.layers[0].overrides.empty());
        QCOMPARE(bench.document.undoStack().count(), 0);
    }
    void boxSelectsAndDeleteDeletes() {
        CanvasBench bench(projectOf(unitSquare(), fourSeeds()));
        bench.drag({0.1, 0.9}, {0.9, 0.6});
        QVERIFY((bench.selection.seeds() == Selection::Seeds{{3, 2}, {3, 3}}));
        bench.key(Qt::Key_Delete);
        QCOMPARE(placedSeeds(bench).size(), std::size_t{2});
        QVERIFY(bench.selection.seeds().empty());
        QCOMPARE(bench.document.undoStack().count(), 1);
    }
    void lassoSelectsSeedsInside() {
        CanvasBench bench(projectOf(unitSquare(), fourSeeds()));
        bench.press({0.05, 0.05}, Qt::AltModifier);
        for (const Vec2 corner : {Vec2{0.95, 0.05}, Vec2{0.9, 0.95}}) bench.moveTo(corner, Qt::AltModifier);
        bench.release({0.05, 0.05}, Qt::AltModifier);
        QVERIFY((bench.selection.seeds() == Selection::Seeds{{3, 0}, {3, 1}, {3, 2}}));
    }
    void controlClickTogglesSelection() {
        CanvasBench bench(projectOf(unitSquare(), fourSeeds()));
        bench.click({0.25, 0.25});
        bench.click({0.75, 0.25}, Qt::ControlModifier);
        QVERIFY((bench.selection.seeds() == Selection::Seeds{{3, 0}, {3, 1}}));
        bench.click({0.25, 0.25}, Qt::ControlModifier);
        QVERIFY((bench.selection.seeds() == Selection::Seeds{{3, 1}}));
        bench.click({-0.05, 0.5});  // a click elsewhere clears the selection
        QVERIFY(bench.selection.seeds().empty());
        QCOMPARE(bench.document.undoStack().count(), 0);
    }
    void arrowKeysMoveTheSelection() {
        CanvasBench bench(projectOf(unitSquare(), fourSeeds()));
        bench.key(Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(bench.selection.seeds().size(), std::size_t{4});
        bench.key(Qt::Key_Right);
        const double pixel = 1.0 / bench.canvas.view().scale;
        QCOMPARE(placedSeeds(bench)[0].position.x, 0.25 + pixel);
        bench.key(Qt::Key_Up, Qt::ShiftModifier);
        QCOMPARE(placedSeeds(bench)[3].position.y, 0.75 + 10.0 * pixel);
        QCOMPARE(bench.document.undoStack().count(), 2);
    }
    void selectsNeighboursAndInverts() {
        CanvasBench bench(projectOf(unitSquare(), fourSeeds()));
        bench.selection.setSeeds({{3, 0}});
        bench.canvas.seedTool().selectNeighbours();
        QVERIFY((bench.selection.seeds() == Selection::Seeds{{3, 0}, {3, 1}, {3, 3}}));
        bench.canvas.seedTool().invertSelection();
        QVERIFY((bench.selection.seeds() == Selection::Seeds{{3, 2}}));
    }
    void restoresAMovedSeed() {
        CanvasBench bench(projectOf(unitSquare(), UniformScatter{.count = 5}));
        const Vec2 seed = bench.seedAt(2);
        bench.drag(seed, {0.5, 0.5});
        QVERIFY(bench.seedAt(2) != seed);
        bench.canvas.seedTool().restoreSelected();
        bench.settle();
        QVERIFY(bench.seedAt(2) == seed);
        QVERIFY(bench.asset().pattern.layers[0].overrides.empty());
    }
    void randomDragsUndoExactly() {
        for (std::uint64_t number = 1; number <= 5; ++number) {
            Random random(number);
            CanvasBench bench(projectOf(unitSquare(), UniformScatter{.count = 12}));
            bench.canvas.setTool(CanvasToolKind::PlaceSeeds);
            const std::string before = projectText(bench.document.project());
            for (int step = 0; step < 10; ++step) {
                const std::size_t seeds = bench.canvas.displayedPattern()->seeds().positions.size();
                const Vec2 to{random.unit(), random.unit()};
                switch (random.below(4)) {
                    case 0: bench.click(to); break;
                    case 1: bench.drag({-0.05, -0.05}, to); break;
                    case 2: bench.key(random.below(2) == 0 ? Qt::Key_Delete : Qt::Key_Left); break;
                    default:
                        if (seeds > 0) bench.drag(bench.seedAt(random.below(seeds)), to);
                }
                QVERIFY2(!verifyProject(bench.document.project()), qPrintable(QString("seed %1").arg(number)));
            }
            while (bench.document.undoStack().canUndo()) bench.document.undoStack().undo();
            QVERIFY2(projectText(bench.document.project()) == before, qPrintable(QString("seed %1").arg(number)));
        }
    }
};

RUBBLE_TEST_WITH(SeedToolTest, QApplication)
#include "SeedToolTest.moc"
