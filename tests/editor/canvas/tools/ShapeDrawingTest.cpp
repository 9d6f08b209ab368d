#include "editor/canvas/tools/OutlineTool.h"
#include "editor/canvas/tools/ShapeDrawing.h"
#include "tests/support/Closeness.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/MeshProjects.h"
#include "tests/support/editor/Canvas.h"

#include <QSignalSpy>
#include <QTest>

using namespace rubble;

namespace {

using Purpose = ShapeDrawing::Purpose;

/// A canvas with snapping on a unit square, in which a shape is drawn.
struct DrawingBench : CanvasBench {
    DrawingBench(Purpose purpose, DraftShape shape)
        : CanvasBench(projectOf(unitSquare(), PlacedSeeds{{{0, {0.3, 0.3}}}})) {
        canvas.setTool(CanvasToolKind::Outline);
        canvas.setSnapping(true);
        canvas.outlineTool().beginDrawing(purpose, shape);
    }
    const Polygon& outline() const { return asset().prism().outline; }
    bool isDrawing() { return canvas.outlineTool().isDrawing(); }
    QString lastMessage() const { return messages.isEmpty() ? QString() : messages.last()[0].toString(); }

    QSignalSpy messages{&canvas, &PatternCanvas::statusMessage};
};

}  // namespace

class ShapeDrawingTest : public QObject {
    Q_OBJECT
private slots:
    void doorToTheGroundIsCutByTwoClicks() {
        DrawingBench bench(Purpose::Cut, DraftShape::Rectangle);
        bench.click({0.4, 0.0});
        QVERIFY(bench.isDrawing());
        bench.click({0.6, 0.7});
        QVERIFY(!bench.isDrawing());
        QCOMPARE(bench.outline().outer.size(), std::size_t{8});
        QVERIFY(std::abs(area(bench.outline()) - 0.86) < 1e-12);
        QCOMPARE(bench.document.undoStack().count(), 1);
        bench.document.undoStack().undo();
        QVERIFY(bench.outline() == unitSquare());
    }
    void rectangleCanBeDragged() {
        DrawingBench bench(Purpose::Add, DraftShape::Rectangle);
        bench.drag({1.0, 0.0}, {1.2, 1.0});
        QVERIFY(!bench.isDrawing());
        QVERIFY(std::abs(area(bench.outline()) - 1.2) < 1e-12);
        QCOMPARE(bench.outline().outer.size(), std::size_t{4});
    }
    void polygonAcrossTheBorderIsCut() {
        DrawingBench bench(Purpose::Cut, DraftShape::Polygon);
        for (const Vec2 corner : {Vec2{0.4, -0.1}, Vec2{0.6, -0.1}, Vec2{0.5, 0.5}}) bench.click(corner);
        bench.key(Qt::Key_Return);
        QVERIFY2(!bench.isDrawing(), qPrintable(bench.lastMessage()));
        QVERIFY(bench.outline().holes.empty());
        QCOMPARE(bench.outline().outer.size(), std::size_t{7});
    }
    void circleInsideBecomesAHole() {
        DrawingBench bench(Purpose::Cut, DraftShape::Circle);
        bench.click({0.5, 0.5});
        bench.click({0.5, 0.7});
        QCOMPARE(bench.outline().holes.size(), std::size_t{1});
    }
    void impossibleCutTellsWhyAndKeepsTheFirstPoint() {
        DrawingBench bench(Purpose::Cut, DraftShape::Rectangle);
        bench.click({0.4, -0.1});
        bench.click({0.6, 1.1});
        QVERIFY(bench.isDrawing());
        QVERIFY2(bench.lastMessage().startsWith("The cut would divide the outline into 2 parts"),
                 qPrintable(bench.lastMessage()));
        QVERIFY(bench.outline() == unitSquare());
        QVERIFY(bench.canvas.hint().startsWith(bench.lastMessage()));  // on the canvas, too
        bench.click({0.6, 0.5});
        QVERIFY(!bench.isDrawing());
    }
    /// A mesh has no outline: where one is to be drawn, a sentence says so. A new prism can be drawn beside it.
    void meshesHaveNoOutlineToDraw() {
        CanvasBench bench(test::meshProject());
        bench.selection.setAsset(50);
        bench.canvas.setTool(CanvasToolKind::Outline);
        QSignalSpy messages(&bench.canvas, &PatternCanvas::statusMessage);
        for (const Purpose purpose : {Purpose::Replace, Purpose::Add, Purpose::Cut}) {
            bench.canvas.outlineTool().beginDrawing(purpose, DraftShape::Rectangle);
            QVERIFY(!bench.canvas.outlineTool().isDrawing());
            QVERIFY(!messages.isEmpty());
            QVERIFY(messages.takeLast()[0].toString().startsWith("Only prisms have an outline"));
        }
        bench.canvas.outlineTool().beginDrawing(Purpose::NewAsset, DraftShape::Rectangle);
        QVERIFY(bench.canvas.outlineTool().isDrawing());
        const std::size_t before = bench.document.project().assets.size();
        for (const Vec2 corner : {Vec2(0.1, 0.1), Vec2(0.4, 0.3)}) {
            bench.moveTo(corner);
            QTest::mouseClick(&bench.canvas, Qt::LeftButton, {}, bench.pixels(corner));
        }
        QCOMPARE(bench.document.project().assets.size(), before + 1);
        QVERIFY(bench.document.project().assets.back().isPrism());
    }
    void nextStepIsShownOnTheCanvas() {
        DrawingBench bench(Purpose::Cut, DraftShape::Polygon);
        QVERIFY(bench.canvas.outlineTool().isPrompting());
        QVERIFY(bench.canvas.hint().startsWith("Click the first corner"));
        const QImage before = bench.canvas.grab().toImage();
        bench.click({0.4, 0.4});
        QVERIFY(bench.canvas.hint().startsWith("Click the next corner"));
        bench.key(Qt::Key_Escape);
        QVERIFY(!bench.canvas.outlineTool().isPrompting());
        QTest::mouseMove(&bench.canvas, bench.pixels({0.3, 0.3}));
        QVERIFY(bench.canvas.grab().toImage().copy(100, 20, 440, 40) != before.copy(100, 20, 440, 40));
    }
};

RUBBLE_TEST_WITH(ShapeDrawingTest, QApplication)
#include "ShapeDrawingTest.moc"
