#include "core/fracture/cuts/PlanarGraph.h"

#include "core/base/Random.h"
#include "core/geometry/predicates/Predicates.h"
#include "core/geometry/predicates/SegmentDistance.h"
#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <glm/geometric.hpp>

#include <cmath>

using namespace rubble;

namespace {

constexpr double kWeld = 1e-9;  // m

/// A graph of cuts, each with its own two points.
PlanarGraph graphOf(const std::vector<std::array<Vec2, 2>>& lines) {
    PlanarGraph graph;
    graph.isNodedGroup = {true, false};
    graph.frame = {.extent = 8.0, .weldDistance = kWeld};
    for (const auto& [from, to] : lines) {
        const auto first = static_cast<std::uint32_t>(graph.points.size());
        graph.points.push_back(from);
        graph.points.push_back(to);
        graph.edges.push_back({.from = first, .to = first + 1, .group = 1});
    }
    return graph;
}

Status split(PlanarGraph& graph, const TaskContext& task = {}) {
    return splitAtIntersections(AcuteCorners(unitSquare(), graph.frame), task, graph);
}

double totalLength(const PlanarGraph& graph) {
    double sum = 0.0;
    for (const PlanarEdge& edge : graph.edges) sum += glm::distance(graph.points[edge.from], graph.points[edge.to]);
    return sum;
}

/// Two edges that meet elsewhere than at a common end.
const char* meetingFault(const PlanarGraph& graph) {
    const auto at = [&](std::uint32_t point) { return graph.points[point]; };
    for (const PlanarEdge& one : graph.edges) {
        for (const PlanarEdge& other : graph.edges) {
            const Vec2 a = at(one.from), b = at(one.to), c = at(other.from), d = at(other.to);
            if (orient2d(a, b, c) * orient2d(a, b, d) < 0 && orient2d(c, d, a) * orient2d(c, d, b) < 0)
                return "Edges cross.";
            for (const std::uint32_t end : {other.from, other.to}) {
                if (end == one.from || end == one.to) continue;
                if (distanceToSegment(at(end), a, b) <= kWeld) return "An edge passes a point.";
            }
        }
    }
    return nullptr;
}

}  // namespace

class PlanarGraphTest : public QObject {
    Q_OBJECT
private slots:
    void crossingEdgesShareANewPoint() {
        PlanarGraph graph = graphOf({{Vec2(0, 0), Vec2(4, 2)}, {Vec2(2, 0), Vec2(2, 4)}});
        QVERIFY(split(graph));
        QCOMPARE(graph.points.size(), std::size_t{5});
        QCOMPARE(graph.points[4], Vec2(2.0, 1.0));
        QCOMPARE(graph.edges.size(), std::size_t{4});
        for (const PlanarEdge& edge : graph.edges) QVERIFY(edge.from == 4 || edge.to == 4);
    }
    void endOnAnEdgeSplitsIt() {
        PlanarGraph graph = graphOf({{Vec2(0, 0), Vec2(4, 0)}, {Vec2(1, 0), Vec2(1, 3)}});
        QVERIFY(split(graph));
        QCOMPARE(graph.points.size(), std::size_t{4});
        QCOMPARE(graph.edges.size(), std::size_t{3});
    }
    void closePointsAreWeldedToTheLower() {
        PlanarGraph graph = graphOf({{Vec2(0, 0), Vec2(2, 0)}, {Vec2(2, 0.5 * kWeld), Vec2(2, 3)}});
        QVERIFY(split(graph));
        QCOMPARE(graph.edges[0].to, 1u);
        QCOMPARE(graph.edges[1].from, 1u);
    }
    void outlineVerticesStay() {
        PlanarGraph graph = graphOf({{Vec2(0, 0), Vec2(2, 0)}, {Vec2(2, 0.5 * kWeld), Vec2(2, 3)}});
        graph.outlineVertex = {kNone, kNone, 0};
        QVERIFY(split(graph));
        QCOMPARE(graph.edges[0].to, 2u);
        QCOMPARE(graph.edges[1].from, 2u);
    }
    void edgesWithoutLengthAreRemoved() {
        PlanarGraph graph = graphOf({{Vec2(0, 0), Vec2(2, 0)}, {Vec2(1, 1), Vec2(1, 1 + 0.5 * kWeld)}});
        graph.edges.push_back({.from = 2, .to = 2, .group = 1});
        QVERIFY(split(graph));
        for (const PlanarEdge& edge : graph.edges) QVERIFY(edge.from != edge.to);
    }
    void piecesOfAnEdgeKeepItsLine() {
        PlanarGraph graph = graphOf({{Vec2(0, 0), Vec2(4, 0)}, {Vec2(2, -1), Vec2(2, 1)}});
        graph.edges[0].line = 7;
        graph.edges[1].line = 9;
        QVERIFY(split(graph));
        QCOMPARE(std::ranges::count(graph.edges, 7u, &PlanarEdge::line), 2);
        QCOMPARE(std::ranges::count(graph.edges, 9u, &PlanarEdge::line), 2);
    }
    void cancelledTaskStops() {
        PlanarGraph graph = graphOf({{Vec2(0, 0), Vec2(4, 2)}, {Vec2(2, 0), Vec2(2, 4)}});
        TaskContext task;
        task.cancel.cancel();
        QCOMPARE(split(graph, task).error().code, ErrorCode::Cancelled);
    }
    void randomEdgesMeetOnlyAtTheirEnds() {
        for (std::uint64_t number = 1; number <= 300; ++number) {
            Random random(number);
            const bool isOnLattice = number % 2 == 0;  // many through one point, or along each other
            const auto point = [&]() -> Vec2 {
                if (!isOnLattice) return {random.between(0.0, 8.0), random.between(0.0, 8.0)};
                return {static_cast<double>(random.below(6)), static_cast<double>(random.below(6))};
            };
            std::vector<std::array<Vec2, 2>> lines;
            while (lines.size() < 20) {
                const Vec2 from = point(), to = point();
                if (from != to) lines.push_back({from, to});
            }
            PlanarGraph graph = graphOf(lines);
            const double length = totalLength(graph);
            const Status status = split(graph);
            QVERIFY2(status, qPrintable(faultOfSeed(number, status ? "" : status.error().message)));
            const char* fault = meetingFault(graph);
            QVERIFY2(!fault, qPrintable(faultOfSeed(number, fault ? fault : "")));
            QVERIFY2(std::abs(totalLength(graph) - length) < 1e-6, qPrintable(faultOfSeed(number, "length")));
        }
    }
};

RUBBLE_TEST(PlanarGraphTest)
#include "PlanarGraphTest.moc"
