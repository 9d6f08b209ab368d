#include "editor/canvas/tools/Snapping.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

namespace {

/// The state of a canvas with 100 pixels per metre, on a wall of 1.5 m by 1 m.
struct SnappingBench {
    explicit SnappingBench(bool isSnapping = true) { state.isSnapping = isSnapping; }

    Vec2 at(Vec2 point, Qt::KeyboardModifiers modifiers = {}) {
        return snapped(state, {state.view.pixels(point), point, modifiers}, targets);
    }

    Document document{Project{}};
    Selection selection;
    Bakes bakes;
    BondPainter painter{document, selection};
    CanvasState state{.document = document,
                      .selection = selection,
                      .bakes = bakes,
                      .bondPainter = painter,
                      .view = {.size = {400.0, 400.0}, .scale = 100.0}};
    SnapTargets targets{.points = {{0.0, 0.0}, {1.03, 0.0}}, .edges = {{Vec2{0.0, 0.0}, Vec2{1.03, 0.0}}}};
};

}  // namespace

class SnappingTest : public QObject {
    Q_OBJECT
private slots:
    void pointsComeBeforeEdges() { QCOMPARE(SnappingBench().at({1.0, 0.02}), Vec2(1.03, 0.0)); }
    void edgesComeBeforeTheGrid() {
        const Vec2 point = SnappingBench().at({0.53, 0.05});
        QVERIFY(std::abs(point.x - 0.53) < 1e-12);
        QCOMPARE(point.y, 0.0);
    }
    void elsewhereTheGridCounts() {
        const Vec2 point = SnappingBench().at({0.53, 0.57});  // the grid's step is 0.2 m
        QVERIFY(std::abs(point.x - 0.6) < 1e-12 && std::abs(point.y - 0.6) < 1e-12);
    }
    void shiftAndSwitchedOffLeaveThePoint() {
        QCOMPARE(SnappingBench().at({1.0, 0.02}, Qt::ShiftModifier), Vec2(1.0, 0.02));
        QCOMPARE(SnappingBench(false).at({1.0, 0.02}), Vec2(1.0, 0.02));
    }
    void nearestPointOfAnEdgeIsClampedToItsEnds() {
        QCOMPARE(nearestOnEdge({0.5, 1.0}, {0.0, 0.0}, {2.0, 0.0}), Vec2(0.5, 0.0));
        QCOMPARE(nearestOnEdge({-3.0, 1.0}, {0.0, 0.0}, {2.0, 0.0}), Vec2(0.0, 0.0));
        QCOMPARE(nearestOnEdge({-3.0, 1.0}, {1.0, 1.0}, {1.0, 1.0}), Vec2(1.0, 1.0));
    }
};

RUBBLE_TEST_WITH(SnappingTest, QCoreApplication)
#include "SnappingTest.moc"
