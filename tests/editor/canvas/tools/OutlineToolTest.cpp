#include "core/asset/checks/VerifyProject.h"
#include "core/base/Random.h"
#include "core/io/project/ProjectFile.h"
#include "editor/canvas/tools/OutlineTool.h"
#include "tests/support/Closeness.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Canvas.h"

#include <QSignalSpy>
#include <QTest>

using namespace rubble;

namespace {

/// A canvas on a unit square with one seed, with the outline tool.
struct OutlineBench : CanvasBench {
    explicit OutlineBench(const Polygon& outline = unitSquare())
        : CanvasBench(projectOf(outline, PlacedSeeds{{{0, {0.3, 0.3}}}})) {
        canvas.setTool(CanvasToolKind::Outline);
    }
    const Polygon& outline() const { return asset().prism().outline; }
};

}  // namespace

class OutlineToolTest : public QObject {
    Q_OBJECT
private slots:
    void pointDragIsOneUndoStep() {
        OutlineBench bench;
        const Vec2 by = bench.metres({1.2, 1.1}) - bench.metres({1.0, 1.0});
        bench.drag({1.0, 1.0}, {1.2, 1.1});
        QVERIFY(isWithinDistance(bench.outline().outer[2], Vec2(1.0, 1.0) + by, 1e-12));
        QCOMPARE(bench.document.undoStack().count(), 1);
        bench.document.undoStack().undo();
        QVERIFY(bench.outline() == unitSquare());
    }
    void seedsStayWhenAPointIsDragged() {
        CanvasBench bench(projectOf(unitSquare(), UniformScatter{.count = 30}));
        const Seeds before = bench.canvas.displayedPattern()->seeds();
        bench.canvas.setTool(CanvasToolKind::Outline);
        bench.drag({1.0, 1.0}, {0.8, 0.8});
        const DrawablePattern& after = *bench.canvas.displayedPattern();
        std::size_t kept = 0;
        for (std::size_t seed = 0; seed < before.ids.size(); ++seed) {
            const std::uint32_t now = after.find(before.ids[seed]);
            const bool isInside =
                containment(bench.asset().prism().outline, before.positions[seed]) == Containment::Inside;
            QCOMPARE(now != kNone, isInside);
            if (isInside) QCOMPARE(after.seeds().positions[now], before.positions[seed]);
            kept += isInside;
        }
        QVERIFY(kept >= 20);
        bench.document.undoStack().undo();
        bench.settle();
        QVERIFY(bench.canvas.displayedPattern()->seeds().positions == before.positions);
    }
    void otherEditEndsADrag() {
        OutlineBench bench;
        bench.press({1.0, 1.0});
        bench.moveTo({1.1, 1.1});
        bench.renameAsset("renamed");
        bench.moveTo({1.2, 1.2});
        bench.release({1.2, 1.2});
        QCOMPARE(bench.asset().name, std::string("renamed"));
    }
    void edgeDragMovesBothPoints() {
        OutlineBench bench;
        bench.canvas.setSnapping(true);
        bench.drag({1.0, 0.5}, {1.2, 0.5});
        QVERIFY(isWithinDistance(bench.outline().outer[1], {1.2, 0.0}, 1e-12) &&
                isWithinDistance(bench.outline().outer[2], {1.2, 1.0}, 1e-12));
    }
    void invalidOutlineIsShownButNotPushed() {
        OutlineBench bench;
        QSignalSpy messages(&bench.canvas, &PatternCanvas::statusMessage);
        bench.press({1.0, 1.0});
        bench.moveTo({0.8, 0.8});
        const Polygon good = bench.outline();
        QVERIFY(!(good == unitSquare()));
        bench.moveTo({-0.2, 0.5});  // across the left edge
        QVERIFY(bench.outline() == good);
        const QImage faulty = bench.canvas.grab().toImage();
        QVERIFY(faulty.pixelColor(bench.pixels({0.0, 0.5}) * faulty.devicePixelRatio()).red() > 180);
        bench.release({-0.2, 0.5});
        QVERIFY(bench.outline() == good);
        QCOMPARE(messages.count(), 1);
        const QString sentence = messages[0][0].toString();
        QVERIFY2(sentence.startsWith("The outline crosses itself"), qPrintable(sentence));
        QVERIFY(sentence.endsWith("The last valid outline was restored."));
    }
    void doubleClickAddsAPointAndDeleteRemovesIt() {
        OutlineBench bench;
        const Vec2 at = bench.metres({0.5, 0.0});
        QTest::mouseDClick(&bench.canvas, Qt::LeftButton, {}, bench.pixels({0.5, 0.0}));
        QCOMPARE(bench.outline().outer.size(), std::size_t{5});
        QCOMPARE(bench.outline().outer[1].x, at.x);
        QCOMPARE(bench.outline().outer[1].y, 0.0);
        bench.key(Qt::Key_Delete);
        QVERIFY(bench.outline() == unitSquare());
        bench.document.undoStack().undo();
        QCOMPARE(bench.outline().outer.size(), std::size_t{5});
    }
    void outlineKeepsThreePoints() {
        OutlineBench bench(Polygon{{{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}}, {}});
        QSignalSpy messages(&bench.canvas, &PatternCanvas::statusMessage);
        bench.click({1.0, 0.0});
        bench.key(Qt::Key_Delete);
        QCOMPARE(bench.outline().outer.size(), std::size_t{3});
        QCOMPARE(messages.count(), 1);
        QVERIFY(messages[0][0].toString().contains("at least 3 points"));
    }
    void holeCanBeDrawnAndDeleted() {
        OutlineBench bench;
        bench.canvas.setSnapping(true);
        bench.canvas.outlineTool().beginDrawing(ShapeDrawing::Purpose::Cut);
        for (const Vec2 corner : {Vec2{0.4, 0.4}, Vec2{0.6, 0.4}, Vec2{0.6, 0.6}}) bench.click(corner);
        QVERIFY(bench.outline().holes.empty());
        bench.key(Qt::Key_Return);
        QCOMPARE(bench.outline().holes.size(), std::size_t{1});
        QVERIFY(signedArea(bench.outline().holes[0]) < 0.0);
        QVERIFY(std::abs(area(bench.outline()) - 0.98) < 1e-12);
        bench.click({0.6, 0.4});
        bench.key(Qt::Key_Delete);  // three points are the minimum
        QVERIFY(bench.outline() == unitSquare());
    }
    void newOutlineIsClosedByItsFirstPoint() {
        OutlineBench bench;
        bench.canvas.setSnapping(true);
        bench.canvas.outlineTool().beginDrawing(ShapeDrawing::Purpose::Replace);
        for (const Vec2 corner : {Vec2{0.2, 0.2}, Vec2{0.2, 0.8}, Vec2{0.9, 0.9}, Vec2{0.8, 0.2}}) bench.click(corner);
        bench.key(Qt::Key_Backspace);
        bench.click({0.8, 0.2});
        bench.click({0.2, 0.2});
        QVERIFY(!bench.canvas.outlineTool().isDrawing());
        QCOMPARE(bench.outline().outer.size(), std::size_t{4});
        QVERIFY(signedArea(bench.outline().outer) > 0.0);  // it was drawn clockwise
        QCOMPARE(bench.document.undoStack().count(), 1);
    }
    void invalidDraftStaysOpenWithAMessage() {
        OutlineBench bench;
        QSignalSpy messages(&bench.canvas, &PatternCanvas::statusMessage);
        bench.canvas.outlineTool().beginDrawing(ShapeDrawing::Purpose::Replace);
        for (const Vec2 corner : {Vec2{0.2, 0.2}, Vec2{0.8, 0.8}, Vec2{0.8, 0.2}, Vec2{0.2, 0.8}}) bench.click(corner);
        bench.key(Qt::Key_Return);
        QCOMPARE(messages.count(), 1);
        QVERIFY(bench.canvas.outlineTool().isDrawing());
        QVERIFY(bench.outline() == unitSquare());
        bench.key(Qt::Key_Escape);
        QVERIFY(!bench.canvas.outlineTool().isDrawing());
        QCOMPARE(bench.document.undoStack().count(), 0);
    }
    void newAssetIsDrawnOnAnEmptyCanvas() {
        Document document(Project{});
        Selection selection;
        Bakes bakes;
        BondPainter painter(document, selection);
        PatternCanvas canvas(document, selection, bakes, painter);
        canvas.resize(400, 300);
        canvas.setTool(CanvasToolKind::Outline);
        canvas.outlineTool().beginDrawing(ShapeDrawing::Purpose::NewAsset);
        for (const QPoint corner : {QPoint(100, 200), QPoint(300, 200), QPoint(200, 100)}) {
            QTest::mouseClick(&canvas, Qt::LeftButton, {}, corner);
        }
        QTest::keyClick(&canvas, Qt::Key_Return);
        QCOMPARE(document.project().assets.size(), std::size_t{1});
        QCOMPARE(selection.asset(), document.project().assets[0].id);
        QVERIFY(!verifyProject(document.project()));
        document.undoStack().undo();
        QVERIFY(document.project() == Project{});
    }
    void keyboardMovesPoints() {
        OutlineBench bench;
        bench.key(Qt::Key_PageDown);
        bench.key(Qt::Key_PageDown);
        bench.key(Qt::Key_Right, Qt::ShiftModifier);
        QVERIFY(isWithinDistance(bench.outline().outer[1], {1.0 + 10.0 / bench.canvas.view().scale, 0.0}, 1e-12));
        bench.key(Qt::Key_Insert);
        QCOMPARE(bench.outline().outer.size(), std::size_t{5});
    }
    void randomDragsKeepValidityAndUndoExactly() {
        for (std::uint64_t number = 1; number <= 8; ++number) {
            Random random(number);
            OutlineBench bench(squareRing());
            const std::string before = projectText(bench.document.project());
            for (int step = 0; step < 12; ++step) {
                const Ring& ring = random.below(2) == 0 ? bench.outline().outer : bench.outline().holes[0];
                const Vec2 from = ring[random.below(ring.size())];
                bench.drag(from, from + Vec2(random.unit() - 0.5, random.unit() - 0.5) * 3.0);
                QVERIFY2(validated(bench.outline()), qPrintable(QString("seed %1").arg(number)));
            }
            while (bench.document.undoStack().canUndo()) bench.document.undoStack().undo();
            QVERIFY2(projectText(bench.document.project()) == before, qPrintable(QString("seed %1").arg(number)));
        }
    }
};

RUBBLE_TEST_WITH(OutlineToolTest, QApplication)
#include "OutlineToolTest.moc"
