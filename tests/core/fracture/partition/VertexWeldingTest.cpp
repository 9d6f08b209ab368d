#include "core/fracture/partition/VertexWelding.h"

#include "core/base/math/Trigonometry.h"
#include "core/fracture/verify/VerifyPartition.h"
#include "core/fracture/voronoi/VoronoiPartition.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <numbers>

using namespace rubble;

namespace {

/// Three strips of the unit square; the one in the middle, between x = 0.5 and 0.5 + width, belongs to seed 1.
Partition threeStrips(double width) {
    Partition partition;
    partition.points = {{0.0, 0.0}, {0.5, 0.0},         {0.5 + width, 0.0}, {1.0, 0.0},
                        {1.0, 1.0}, {0.5 + width, 1.0}, {0.5, 1.0},         {0.0, 1.0}};
    partition.seedOfPiece = {0, 1, 2};
    partition.ringsOfPiece = {0, 1, 2, 3};
    partition.cornersOfRing = {0, 4, 8, 12};
    partition.corners = {0, 1, 6, 7, 1, 2, 5, 6, 2, 3, 4, 5};
    partition.neighbours = {kNone, 1, kNone, kNone, kNone, 2, kNone, 0, kNone, kNone, kNone, 1};
    partition.pieceOfSeed = {0, 1, 2};
    return partition;
}

Polygon regularPolygon(std::size_t corners) {
    Polygon outline;
    for (std::size_t k = 0; k < corners; ++k) {
        const double angle = 2.0 * std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(corners);
        outline.outer.push_back({cosine(angle), sine(angle)});
    }
    return outline;
}

}  // namespace

class VertexWeldingTest : public QObject {
    Q_OBJECT
private slots:
    void pieceWithoutWidthIsRemoved() {
        Partition partition = threeStrips(1e-17);
        weldVertices(partition, {.pairs = {{1, 2}, {5, 6}}, .weldDistance = 1e-15});
        QCOMPARE(partition.pieceCount(), 2u);
        QCOMPARE(partition.seedOfPiece[0], 0u);
        QCOMPARE(partition.seedOfPiece[1], 2u);
        QCOMPARE(contactsOf(partition, 0, 0.5).size(), std::size_t{1});
        QCOMPARE(contactsOf(partition, 0, 0.5)[0].piece, 1u);
        partition.pieceOfSeed = {0, kNone, 1};
        QCOMPARE(verifyPartition(partition, unitSquare()).value_or(""), std::string());
    }
    void fixedPointsDoNotMove() {
        Partition partition = threeStrips(1e-17);
        weldVertices(partition, {.pairs = {{1, 2}, {5, 6}}, .fixedBegin = 2, .fixedEnd = 3, .weldDistance = 1e-15});
        QVERIFY(std::ranges::count(partition.corners, 2u) > 0);
        QCOMPARE(std::ranges::count(partition.corners, 1u), 0);
    }
    void partitionWithoutCoincidencesDoesNotChange() {
        Partition partition = threeStrips(0.25);
        weldVertices(partition, {.weldDistance = 1e-15});
        QCOMPARE(partition.corners, threeStrips(0.25).corners);
        QCOMPARE(partition.neighbours, threeStrips(0.25).neighbours);
    }
    void workIsLinearInTheCornersOfAPiece_data() {
        QTest::addColumn<int>("corners");
        for (const int corners : {1000, 64000}) QTest::addRow("%d corners", corners) << corners;
    }
    /// Two halves of a polygon, both of which are examined because of a vertex at their common edge.
    void workIsLinearInTheCornersOfAPiece() {
        QFETCH(int, corners);
        const Polygon outline = regularPolygon(static_cast<std::size_t>(corners));
        Result<Partition> halves = voronoiPartition(outline, std::vector<Vec2>{{0.0, -0.25}, {0.0, 0.25}});
        QVERIFY(halves.hasValue() && halves->pieceCount() == 2);
        const std::uint32_t vertex = halves->corners[0];
        const std::size_t visited = weldVertices(*halves, {.touches = {{vertex, 0, 1}}, .weldDistance = 1e-15});
        QCOMPARE(verifyPartition(*halves, outline).value_or(""), std::string());
        QVERIFY2(visited <= 4 * static_cast<std::size_t>(corners), qPrintable(QString::number(visited)));
    }
};

RUBBLE_TEST(VertexWeldingTest)
#include "VertexWeldingTest.moc"
