#include "editor/canvas/widget/CanvasTools.h"

#include "editor/canvas/tools/BondBrushTool.h"
#include "tests/support/TestProgram.h"
#include "tests/support/editor/Canvas.h"

using namespace rubble;

class CanvasToolsTest : public QObject {
    Q_OBJECT
private slots:
    void eachKindHasItsTool() {
        CanvasBench bench(projectOf(unitSquare(), PlacedSeeds{}));
        BondPainter painter(bench.document, bench.selection);
        const CanvasState state{
            .document = bench.document, .selection = bench.selection, .bakes = bench.bakes, .bondPainter = painter};
        CanvasTools tools(state);
        QCOMPARE(tools.all().size(), std::size_t{6});
        QCOMPARE(static_cast<void*>(&tools.prepare(CanvasToolKind::PlaceSeeds)), static_cast<void*>(&tools.seeds()));
        for (const auto& [kind, brush] : {std::pair(CanvasToolKind::AnchorBrush, BondBrush::Anchor),
                                          std::pair(CanvasToolKind::StrengthBrush, BondBrush::Strength),
                                          std::pair(CanvasToolKind::NeverBreaksBrush, BondBrush::NeverBreaks)}) {
            QVERIFY(isBondBrush(kind) && isBrush(kind));
            QCOMPARE(static_cast<void*>(&tools.prepare(kind)), static_cast<void*>(&tools.bondBrush()));
            QCOMPARE(painter.settings().brush, brush);
            QVERIFY(painter.isOn());
        }
        tools.prepare(CanvasToolKind::Seeds);
        QVERIFY(!painter.isOn());
        QVERIFY(isBrush(CanvasToolKind::Brush) && !isBondBrush(CanvasToolKind::Brush));
        QVERIFY(!isBrush(CanvasToolKind::Seeds));
    }
};

RUBBLE_TEST_WITH(CanvasToolsTest, QApplication)
#include "CanvasToolsTest.moc"
