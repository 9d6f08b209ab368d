#include "core/fracture/kinds/CrackLines.h"

#include "core/fracture/cuts/CutSet.h"
#include "core/fracture/layer/LayerContext.h"
#include "core/fracture/layer/LayerKind.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <cmath>

using namespace rubble;

namespace {

Status cutBy(const CrackLines& layer, CutSet& cuts, const TaskContext& task = {}) {
    const Polygon outline = unitSquare();
    return layer.cut({{.layerId = 7, .randomSeed = 0, .overrides = {}, .task = task}, outline}, cuts);
}

std::string faultOf(const CrackLines& layer) { return layer.fault().value_or(""); }

}  // namespace

class CrackLinesTest : public QObject {
    Q_OBJECT
private slots:
    void lineIsAChainOfCuts() {
        CutSet cuts;
        QVERIFY(cutBy({{{4, {{0, 0}, {1, 0}, {1, 2}}}}}, cuts));
        QCOMPARE(cuts.points, (std::vector<Vec2>{{0, 0}, {1, 0}, {1, 2}}));
        QCOMPARE(cuts.edges.size(), std::size_t{2});
        QCOMPARE(cuts.edges[1].from, 1u);
        QCOMPARE(cuts.edges[1].to, 2u);
        QCOMPARE(cuts.edges[1].line, 4u);
        QCOMPARE(cuts.layers.size(), std::size_t{1});
        QCOMPARE(cuts.layers[0].id, 7u);
        QCOMPARE(cuts.layers[0].edgesEnd, 2u);
        QVERIFY(!cuts.layers[0].isNoded && !cuts.layers[0].cellAt);
    }
    void closedLineEndsAtItsFirstPoint() {
        CutSet cuts;
        QVERIFY(cutBy({{{0, {{0, 0}, {1, 0}, {1, 2}, {0, 0}}}}}, cuts));
        QCOMPARE(cuts.points.size(), std::size_t{3});
        QCOMPARE(cuts.edges.back().to, 0u);
    }
    void laterLayersFollow() {
        CutSet cuts;
        QVERIFY(cutBy({{{0, {{0, 0}, {1, 0}}}}}, cuts));
        QVERIFY(cutBy({{{0, {{0, 1}, {1, 1}}}, {1, {{0, 2}, {1, 2}}}}}, cuts));
        QCOMPARE(cuts.layers[1].edgesEnd, 3u);
        QCOMPARE(cuts.edges[2].from, 4u);
    }
    void cancelledTaskStops() {
        TaskContext task;
        task.cancel.cancel();
        CutSet cuts;
        QCOMPARE(cutBy({{{0, {{0, 0}, {1, 0}}}}}, cuts, task).error().code, ErrorCode::Cancelled);
    }
    void faultsNameTheLineAndThePoint() {
        QCOMPARE(faultOf({{{0, {{0, 0}, {1, 0}}}, {3, {{0, 0}, {1, 1}}}}}), "");
        QCOMPARE(faultOf({{{5, {{0, 0}}}}}), "crack line 5 has fewer than two points");
        QCOMPARE(faultOf({{{5, {{0, 0}, {1, 2}, {1, 2}}}}}), "point 2 of crack line 5 equals the one before, (1, 2)");
        QCOMPARE(faultOf({{{5, {{0, 0}, {1, 0}}}, {5, {{0, 0}, {1, 1}}}}}),
                 "crack line 5 does not come after crack line 5");
        QVERIFY(faultOf({{{2, {{0, 0}, {HUGE_VAL, 0}}}}}).starts_with("point 1 of crack line 2 "));
    }
    void kindCutsAndCountsItsLines() {
        QVERIFY(CrackLines::kKind.role == LayerRole::Cuts);
        const CrackLines two{{{0, {{0, 0}, {1, 0}}}, {3, {{0, 0}, {1, 1}}}}};
        QCOMPARE(two.elementCount(), std::size_t{2});
        QCOMPARE(two.estimatedPieces(1.0), 2.0);
    }
};

RUBBLE_TEST(CrackLinesTest)
#include "CrackLinesTest.moc"
