#include "editor/canvas/tools/CrackLineTool.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Canvas.h"

#include <QTest>

using namespace rubble;

namespace {

/// A canvas on a square without seeds, with the crack line tool.
struct CrackLineBench : CanvasBench {
    CrackLineBench() : CanvasBench(projectOf(unitSquare(), PlacedSeeds{})) {
        canvas.setTool(CanvasToolKind::CrackLines);
    }

    const std::vector<CrackLines::CrackLine>& lines() const {
        return std::get<CrackLines>(asset().pattern.layers.back().parameters).lines;
    }
    std::uint32_t pieces() const { return canvas.displayedPattern()->partition().pieceCount(); }
};

}  // namespace

class CrackLineToolTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void dragDrawsACrackInOneUndoStep() {
        CrackLineBench bench;
        bench.drag({-0.05, 0.5}, {1.05, 0.5});
        QCOMPARE(bench.lines().size(), std::size_t{1});
        QCOMPARE(bench.lines()[0].points.size(), std::size_t{2});  // a straight line needs only two
        QCOMPARE(bench.pieces(), 2u);
        QCOMPARE(bench.document.undoStack().count(), 1);
        bench.document.undoStack().undo();
        bench.settle();
        QCOMPARE(bench.asset().pattern.layers.size(), std::size_t{1});
        QCOMPARE(bench.pieces(), 1u);
    }
    void clicksDrawStraightSegments() {
        CrackLineBench bench;
        bench.click({-0.05, 0.3});
        bench.click({0.5, 0.6});
        bench.click({1.05, 0.3});
        QCOMPARE(bench.document.undoStack().count(), 0);
        QVERIFY(bench.canvas.crackLineTool().isDrawing());
        bench.key(Qt::Key_Return);
        QCOMPARE(bench.lines()[0].points.size(), std::size_t{3});
        QCOMPARE(bench.lines()[0].points[1], bench.metres({0.5, 0.6}));
        QCOMPARE(bench.pieces(), 2u);
    }
    void escapeCancelsTheDraft() {
        CrackLineBench bench;
        bench.click({0.2, 0.3});
        bench.key(Qt::Key_Escape);
        QVERIFY(!bench.canvas.crackLineTool().isDrawing());
        QCOMPARE(bench.document.undoStack().count(), 0);
    }
    void pointsCanBeDraggedAndDeleted() {
        CrackLineBench bench;
        for (const Vec2 point : {Vec2(-0.05, 0.3), Vec2(0.5, 0.6), Vec2(1.05, 0.3)}) bench.click(point);
        bench.key(Qt::Key_Return);
        bench.drag({0.5, 0.6}, {0.4, 0.8});
        QVERIFY(glm::distance(bench.lines()[0].points[1], Vec2(0.4, 0.8)) < 0.01);
        QCOMPARE(bench.document.undoStack().count(), 2);
        bench.key(Qt::Key_Delete);
        QCOMPARE(bench.lines()[0].points.size(), std::size_t{2});
        bench.click({-0.05, 0.3});
        bench.key(Qt::Key_Delete);  // less than two points: the line is deleted
        QVERIFY(bench.lines().empty());
        QCOMPARE(bench.pieces(), 1u);
    }
};

RUBBLE_TEST_WITH(CrackLineToolTest, QApplication)
#include "CrackLineToolTest.moc"
