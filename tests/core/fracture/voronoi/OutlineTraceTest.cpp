#include "core/fracture/voronoi/OutlineTrace.h"

#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/TracedCells.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <numeric>

using namespace rubble;
using test::TracedCells;

namespace {

const std::vector<Vec2> kHalves{{0.25, 0.5}, {0.75, 0.5}};

/// What is wrong with the arcs of a trace, or nothing: each is in the list of its cell, from the crossing that enters
/// the cell to the one that leaves it, and all vertices are on an arc, in the cell that is nearest.
const char* arcsFault(const TracedCells& cells) {
    const OutlineTrace& trace = cells.trace;
    std::vector<int> visits(trace.vertices.size()), listed(trace.arcs.size());
    for (std::uint32_t site = 0; site < cells.siteCount(); ++site) {
        for (std::uint32_t k = trace.firstArc[site]; k != kNone; k = trace.arcs[k].nextInCell) {
            const BoundaryArc& arc = trace.arcs[k];
            ++listed[k];
            if (arc.cell != site) return "An arc is in the list of another cell.";
            if ((arc.enter == kNone) != (arc.leave == kNone)) return "An arc enters, and does not leave.";
            if (arc.enter != kNone) {
                const std::uint32_t enter = trace.crossings[arc.enter].halfEdge;
                if (targetOf(cells.delaunay, enter) != site) return "An arc enters another cell.";
                if (cells.delaunay.origin(trace.crossings[arc.leave].halfEdge) != site) return "Another cell is left.";
            }
            const std::uint32_t begin = trace.ringStarts[arc.ring], end = trace.ringStarts[arc.ring + 1];
            for (std::uint32_t i = 0, vertex = arc.firstVertex; i < arc.vertexCount; ++i) {
                ++visits[vertex];
                const auto distanceTo = [&](Vec2 to) { return glm::distance(to, trace.vertices[vertex]); };
                double nearest = 1e308;
                for (const Vec2 to : cells.delaunay.sites) nearest = std::min(nearest, distanceTo(to));
                if (distanceTo(cells.delaunay.sites[site]) > nearest + 1e-12) return "A vertex is in another cell.";
                vertex = vertex + 1 == end ? begin : vertex + 1;
            }
        }
    }
    if (std::ranges::any_of(visits, [](int count) { return count != 1; })) return "A vertex is not on one arc.";
    if (std::ranges::any_of(listed, [](int count) { return count != 1; })) return "An arc is not in one list.";
    return nullptr;
}

}  // namespace

class OutlineTraceTest : public QObject {
    Q_OBJECT
private slots:
    void outlineCrossesABisectorTwice() {
        const TracedCells cells(unitSquare(), kHalves);
        const OutlineTrace& trace = cells.trace;
        QCOMPARE(trace.crossings.size(), std::size_t{2});
        QCOMPARE(trace.crossings[0].edge, 0u);  // the lower edge, to the right
        QCOMPARE(trace.crossings[0].edgeEnd, 1u);
        QCOMPARE(cells.delaunay.origin(trace.crossings[0].halfEdge), cells.siteOf(0));
        QCOMPARE(trace.crossings[1].edge, 2u);
        const BoundaryArc& right = trace.arcs[trace.firstArc[cells.siteOf(1)]];
        QCOMPARE(right.firstVertex, 1u);
        QCOMPARE(right.vertexCount, 2u);
        QCOMPARE(right.nextInCell, kNone);
        QCOMPARE(trace.arcs[trace.firstArc[cells.siteOf(0)]].firstVertex, 3u);
    }
    void wholeRingInACellIsOneArc() {
        const Polygon outline{rectangle({0, 0}, {8, 8}), {reversed(rectangle({1, 1}, {2, 2}))}};
        const TracedCells cells(outline, {{2.0, 4.0}, {6.0, 4.0}});
        std::uint32_t wholeRings = 0;
        for (const BoundaryArc& arc : cells.trace.arcs) {
            if (arc.enter != kNone) continue;
            ++wholeRings;
            QCOMPARE(arc.ring, 1u);
            QCOMPARE(arc.vertexCount, 4u);
            QCOMPARE(arc.cell, cells.siteOf(0));
        }
        QCOMPARE(wholeRings, 1u);
    }
    void cellThatTheOutlineDoesNotEnterHasNoArc() {
        std::vector<Vec2> grid;
        for (int k = 0; k < 9; ++k) grid.push_back({1.5 + 2.5 * (k % 3), 1.5 + 2.5 * (k / 3)});
        const TracedCells cells({rectangle({0, 0}, {8, 8}), {}}, grid);
        for (std::uint32_t seed = 0; seed < 9; ++seed)
            QCOMPARE(cells.trace.firstArc[cells.siteOf(seed)] == kNone, seed == 4);
        QCOMPARE(cells.trace.crossings.size(), std::size_t{8});
    }
    void arcsPassThroughTheNearestCells_data() {
        QTest::addColumn<bool>("isOnLattice");
        QTest::newRow("anywhere") << false;
        QTest::newRow("on a lattice") << true;
    }
    void arcsPassThroughTheNearestCells() {
        QFETCH(bool, isOnLattice);
        for (std::uint64_t number = 1; number <= 500; ++number) {
            Random random(number);
            const TracedCells cells(combWithHole(), test::randomSeeds(random, 40, isOnLattice));
            const char* fault = arcsFault(cells);
            QVERIFY2(!fault, qPrintable(faultOfSeed(number, fault ? fault : "")));
        }
    }
};

RUBBLE_TEST(OutlineTraceTest)
#include "OutlineTraceTest.moc"
