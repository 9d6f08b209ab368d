#include "editor/canvas/tools/MeasureTool.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Canvas.h"

#include <QTest>

using namespace rubble;

class MeasureToolTest : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void dragSnapsToCorners() {
        CanvasBench bench(projectOf(unitSquare(), PlacedSeeds{{{0, {0.25, 0.5}}}}));
        bench.canvas.setTool(CanvasToolKind::Measure);
        bench.canvas.setSnapping(true);
        bench.drag({0.01, 0.01}, {0.99, 0.99});
        const std::optional<MeasureTool::Line>& line = bench.canvas.measureTool().line();
        QVERIFY(line && line->from == Vec2(0.0, 0.0) && line->to == Vec2(1.0, 1.0));
        QCOMPARE(bench.document.undoStack().count(), 0);
        bench.key(Qt::Key_Escape);
        QVERIFY(!line);
    }
    void dragSnapsToSeedsAndEdges() {
        CanvasBench bench(projectOf(unitSquare(), PlacedSeeds{{{0, {0.25, 0.5}}}}));
        bench.canvas.setTool(CanvasToolKind::Measure);
        bench.canvas.setSnapping(true);
        bench.drag({0.255, 0.495}, {0.543, 1.01});
        const std::optional<MeasureTool::Line>& line = bench.canvas.measureTool().line();
        QVERIFY(line && line->from == Vec2(0.25, 0.5) && line->to.y == 1.0);
        bench.drag({0.255, 0.495}, {0.543, 1.01}, Qt::ShiftModifier);
        QVERIFY(line && line->from == bench.metres({0.255, 0.495}));
    }
    void controlSnapsToFifteenDegrees() {
        CanvasBench bench(projectOf(unitSquare(), PlacedSeeds{{{0, {0.25, 0.5}}}}));
        bench.canvas.setTool(CanvasToolKind::Measure);
        bench.drag({0.1, 0.1}, {0.6, 0.62}, Qt::ControlModifier);
        const MeasureTool::Line line = bench.canvas.measureTool().line().value();
        const Vec2 along = line.to - line.from;
        QVERIFY(std::abs(along.x - along.y) < 1e-12);
    }
};

RUBBLE_TEST_WITH(MeasureToolTest, QApplication)
#include "MeasureToolTest.moc"
