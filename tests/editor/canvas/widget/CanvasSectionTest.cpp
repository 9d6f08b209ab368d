// Tests editor/canvas/widget/PatternCanvas.cpp, editor/canvas/widget/SectionBar.cpp and the tools for sections of
// meshes, with editor/background/SectionUpdater.cpp and editor/document/sections/Sections.cpp.
#include "core/asset/bake/FragmentLookup.h"
#include "core/asset/project/AssetShape.h"
#include "editor/background/Baker.h"
#include "editor/background/SectionUpdater.h"
#include "editor/canvas/tools/BrushTool.h"
#include "editor/canvas/tools/CrackLineTool.h"
#include "editor/canvas/tools/OutlineTool.h"
#include "editor/canvas/tools/SeedTool.h"
#include "editor/canvas/widget/PatternCanvas.h"
#include "editor/canvas/widget/SectionBar.h"
#include "editor/document/EnteredFragment.h"
#include "tests/support/Patience.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Fragments.h"
#include "tests/support/asset/MeshAsset.h"

#include <QSlider>
#include <QTest>
#include <QToolButton>

using namespace rubble;
using namespace rubble::test;

namespace {

Project meshProject(Asset asset) {
    Project project;
    project.nextId = 20;
    project.materials = {{.id = 1, .name = "stone"}};
    project.assets = {std::move(asset)};
    return project;
}

/// A canvas on a mesh, with what updates its section.
struct SectionBench {
    explicit SectionBench(Asset asset) : document(meshProject(std::move(asset))) {
        selection.prune(document.project());
        canvas.setSections(sections);
        canvas.resize(640, 480);
        canvas.show();
        settle();
    }
    const Asset& asset() const { return document.project().assets.front(); }
    bool isSettled() const {
        const auto baked = bakes.find(asset().id);
        return baked && baked->bake && *baked->asset == asset() && shown();
    }
    void settle() {
        QVERIFY(QTest::qWaitFor([&] { return isSettled(); }, kPatience));
        QCoreApplication::processEvents();
    }
    const DrawablePattern* shown() const { return canvas.displayedPattern(); }
    const Bake& bake() const { return *bakes.find(asset().id)->bake; }
    double shownArea() const {
        double sum = 0.0;
        for (std::uint32_t piece = 0; piece < shown()->partition().pieceCount(); ++piece) sum += shown()->area(piece);
        return sum;
    }
    QPoint pixels(Vec2 metres) const { return canvas.view().pixels(metres).toPoint(); }
    void click(Vec2 at) {
        QTest::mouseMove(&canvas, pixels(at));
        QTest::mouseClick(&canvas, Qt::LeftButton, {}, pixels(at));
        settle();
    }
    void drag(Vec2 from, Vec2 to) {
        QTest::mouseMove(&canvas, pixels(from));
        QTest::mousePress(&canvas, Qt::LeftButton, {}, pixels(from));
        for (const Vec2 at : {(from + to) / 2.0, to}) {
            const QPointF position(pixels(at));
            QMouseEvent event(QEvent::MouseMove, position, canvas.mapToGlobal(position), Qt::NoButton, Qt::LeftButton,
                              {});
            QCoreApplication::sendEvent(&canvas, &event);
        }
        QTest::mouseRelease(&canvas, Qt::LeftButton, {}, pixels(to));
        settle();
    }

    Document document;
    Selection selection;
    Bakes bakes;
    Sections sections;
    SectionUpdater updater{selection, sections, bakes};
    Baker baker{document, selection, bakes};
    BondPainter bondPainter{document, selection};
    PatternCanvas canvas{document, selection, bakes, bondPainter};
};

}  // namespace

class CanvasSectionTest : public QObject {
    Q_OBJECT
private slots:
    void aMeshIsShownInTheMiddle() {
        SectionBench bench(meshAsset(cubes({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}), 30));
        QVERIFY(std::abs(bench.shownArea() - 3.0) < 1e-9);
        QVERIFY(bench.canvas.displayedAsset()->isPrism());
        QVERIFY(bench.shown()->seeds().positions.size() < 30);
        for (std::uint32_t piece = 0; piece < bench.shown()->partition().pieceCount(); ++piece) {
            const std::optional<std::uint32_t> number = fragmentAt(bench.bake(), bench.shown()->fragmentPath(piece));
            QVERIFY(number);
            QCOMPARE(bench.shown()->volume(piece), bench.bake().fragment(*number).solid.volume());
        }
        // What is under the pointer has neighbours, by their common edges.
        QVERIFY(!bench.shown()->neighbours(bench.shown()->pieceAt({0.5, 0.5})).empty());
    }
    /// Also where the bake comes after the asset was selected: the section is not known before.
    void aMeshFillsTheView() {
        SectionBench bench(meshAsset(transformed(bumpySphere(24), Mat3(0.05)), 20));
        QVERIFY(0.1 * bench.canvas.view().scale > 0.5 * 0.5 * bench.canvas.height());
        QVERIFY(0.1 * bench.canvas.view().scale < bench.canvas.height());
    }
    void theBarMovesTheSection() {
        SectionBench bench(meshAsset(bumpySphere(24), 60));
        const double middle = bench.shownArea();
        auto* bar = bench.canvas.findChild<SectionBar*>();
        QVERIFY(bar && bar->isVisible());
        bar->findChild<QSlider*>()->setValue(950);
        QVERIFY(bench.shownArea() < 0.5 * middle);
        QTest::mouseClick(bar->findChildren<QToolButton*>()[0], Qt::LeftButton);
        QCOMPARE(bench.sections.of(3).axis, 0);
        const std::optional<SectionPlane> plane = bench.shown()->baked().section;
        QVERIFY(plane && plane->normal().x > 0.99 && plane->origin.x > 0.5);
        bar->findChild<QSlider*>()->setValue(500);
        QVERIFY(bench.shownArea() > 0.5 * middle);
        QTest::mouseClick(bar->findChildren<QToolButton*>()[1], Qt::LeftButton);
        QVERIFY(bench.shown()->baked().section->normal().y > 0.99);
    }
    void seedsArePlacedAndMovedInTheSection() {
        SectionBench bench(meshAsset(cubes({{0, 0, 0}, {1, 0, 0}}), 4));
        bench.sections.set(3, {.axis = 1, .position = 0.25});
        bench.canvas.setTool(CanvasToolKind::PlaceSeeds);
        bench.click({0.7, -0.3});
        const PatternLayer& layer = bench.asset().pattern.layers.back();
        const auto* placed = std::get_if<PlacedSeeds>(&layer.parameters);
        QVERIFY(placed && placed->seeds.size() == 1);
        const Vec3 at(placed->seeds[0].position, placed->seeds[0].height);
        const double pixel = 2.0 / bench.canvas.view().scale;
        QVERIFY(glm::distance(at, Vec3(0.7, 0.25, 0.3)) < pixel);
        QVERIFY(std::abs(at.y - 0.25) < 1e-9);
        bench.drag({0.7, -0.3}, {1.2, -0.6});
        const auto& moved = std::get<PlacedSeeds>(bench.asset().pattern.layers.back().parameters).seeds[0];
        QVERIFY(glm::distance(Vec3(moved.position, moved.height), Vec3(1.2, 0.25, 0.6)) < 2.0 * pixel);
    }
    void scatteredSeedsKeepTheirDistanceFromThePlane() {
        SectionBench bench(meshAsset(cubes({{0, 0, 0}, {1, 0, 0}}), 3));
        const SeedId id = bench.shown()->seeds().ids[0];
        const double height = bench.shown()->seeds().heights[0];
        const Vec2 from = bench.shown()->seeds().positions[0];
        const Vec3 before = bench.shown()->baked().section->movedUp(height).inSpace(from);
        bench.canvas.setTool(CanvasToolKind::PlaceSeeds);
        const Vec2 to = from + Vec2(from.x < 1.0 ? 0.2 : -0.2, from.y < 0.5 ? 0.1 : -0.1);
        bench.drag(from, to);
        const SeedOverride& moved = bench.asset().pattern.layers[0].overrides.at(0);
        QCOMPARE(moved.index, id.index);
        const Vec3 now(moved.position, moved.height);
        QVERIFY(std::abs(now.z - before.z) < 1e-12);
        QVERIFY(glm::distance(now, before + Vec3(to - from, 0.0)) < 4.0 / bench.canvas.view().scale);
    }
    void fragmentsAreSelectedAndEntered() {
        Asset asset = meshAsset(cubes({{0, 0, 0}, {1, 0, 0}}), 3);
        asset.levels = {scatteredLevel(8, 4)};
        SectionBench bench(asset);
        bench.click({0.5, 0.5});
        QCOMPARE(bench.selection.fragments().seeds.size(), std::size_t{1});
        const FragmentPath path = bench.shown()->fragmentPath(bench.shown()->pieceAt({0.5, 0.5}));
        enterFragment(bench.selection, path);
        bench.settle();
        QCOMPARE(bench.shown()->baked().parent, path);
        QVERIFY(bench.shown()->partition().pieceCount() > 1);
        exitToFragment(bench.selection, {});
        bench.settle();
        QVERIFY(bench.shown()->baked().parent.empty());
    }
    void toolsOfThePlaneDoNothing() {
        SectionBench bench(meshAsset(torus(24, 16), 20));
        const Project before = bench.document.project();
        for (const CanvasToolKind kind : {CanvasToolKind::Outline, CanvasToolKind::CrackLines, CanvasToolKind::Brush,
                                          CanvasToolKind::Measure, CanvasToolKind::Seeds}) {
            bench.canvas.setTool(kind);
            bench.drag({0.7, 0.7}, {0.9, 0.2});
            QTest::keyClick(&bench.canvas, Qt::Key_Delete);
        }
        QVERIFY(before == bench.document.project());
        QVERIFY(!bench.canvas.picture({640, 480}).isNull());
    }
    void prismsHaveNoBar() {
        SectionBench bench(meshAsset(torus(24, 16), 20));
        Edit edit{.text = "Replace"};
        Asset prism = bench.asset();
        prism.shape = Prism{squareRing(), 0.5};
        edit.replacements = {Replacement<Asset>{prism.id, prism}};
        bench.document.push(std::move(edit));
        bench.settle();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.canvas.findChild<SectionBar*>()->isVisible(), kPatience);
        QVERIFY(!bench.shown()->baked().section);
    }
};

RUBBLE_TEST_WITH(CanvasSectionTest, QApplication)
#include "CanvasSectionTest.moc"
