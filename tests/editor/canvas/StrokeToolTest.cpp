#include "editor/canvas/StrokeTool.h"
#include "tests/support/Canvas.h"

#include <QTest>

using namespace rubble;

namespace {

/// A canvas on a square without seeds, with the stroke tool in hand.
struct StrokeBench : CanvasBench {
    StrokeBench() : CanvasBench(projectOf(unitSquare(), PlacedSeeds{})) { canvas.setTool(CanvasToolKind::Strokes); }

    const std::vector<Strokes::Stroke>& strokes() const {
        return std::get<Strokes>(asset().pattern.layers.back().parameters).strokes;
    }
    std::uint32_t pieces() const { return canvas.shownPattern()->partition().pieceCount(); }
};

}  // namespace

class StrokeToolTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void aDragDrawsACrackAndIsOneStep() {
        StrokeBench bench;
        bench.drag({-0.05, 0.5}, {1.05, 0.5});
        QCOMPARE(bench.strokes().size(), std::size_t{1});
        QCOMPARE(bench.strokes()[0].points.size(), std::size_t{2});  // a straight line needs no more
        QCOMPARE(bench.pieces(), 2u);
        QCOMPARE(bench.document.undoStack().count(), 1);
        bench.document.undoStack().undo();
        bench.settle();
        QCOMPARE(bench.asset().pattern.layers.size(), std::size_t{1});
        QCOMPARE(bench.pieces(), 1u);
    }
    void clicksDrawFromPointToPoint() {
        StrokeBench bench;
        bench.click({-0.05, 0.3});
        bench.click({0.5, 0.6});
        bench.click({1.05, 0.3});
        QCOMPARE(bench.document.undoStack().count(), 0);
        QVERIFY(bench.canvas.strokeTool().isDrawing());
        bench.key(Qt::Key_Return);
        QCOMPARE(bench.strokes()[0].points.size(), std::size_t{3});
        QCOMPARE(bench.strokes()[0].points[1], bench.metres({0.5, 0.6}));
        QCOMPARE(bench.pieces(), 2u);
    }
    void escapeGivesUp() {
        StrokeBench bench;
        bench.click({0.2, 0.3});
        bench.key(Qt::Key_Escape);
        QVERIFY(!bench.canvas.strokeTool().isDrawing());
        QCOMPARE(bench.document.undoStack().count(), 0);
    }
    void pointsAreDraggedAndDeleted() {
        StrokeBench bench;
        for (const Vec2 point : {Vec2(-0.05, 0.3), Vec2(0.5, 0.6), Vec2(1.05, 0.3)}) bench.click(point);
        bench.key(Qt::Key_Return);
        bench.drag({0.5, 0.6}, {0.4, 0.8});
        QVERIFY(glm::distance(bench.strokes()[0].points[1], Vec2(0.4, 0.8)) < 0.01);
        QCOMPARE(bench.document.undoStack().count(), 2);
        bench.key(Qt::Key_Delete);
        QCOMPARE(bench.strokes()[0].points.size(), std::size_t{2});
        bench.click({-0.05, 0.3});
        bench.key(Qt::Key_Delete);  // less than two points are no stroke
        QVERIFY(bench.strokes().empty());
        QCOMPARE(bench.pieces(), 1u);
    }
};

QTEST_MAIN(StrokeToolTest)
#include "StrokeToolTest.moc"
