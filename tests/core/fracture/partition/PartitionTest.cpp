#include "core/fracture/partition/Partition.h"

#include "core/fracture/pieces/PieceGap.h"
#include "core/fracture/voronoi/VoronoiPartition.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <algorithm>

using namespace rubble;

namespace {

/// Vertical strips of the unit square, shrunk by a gap of 0.2 m.
Partition shrunkStrips(const std::vector<Vec2>& seeds) {
    return *shrunkPartition(*voronoiPartition(unitSquare(), seeds), 0.1);
}

std::uint32_t pieceOf(const Partition& partition, std::size_t seed) { return partition.pieceOfSeed[seed]; }

}  // namespace

class PartitionTest : public QObject {
    Q_OBJECT
private slots:
    void outlineOfAPiece() {
        const Partition halves = *voronoiPartition(unitSquare(), std::vector<Vec2>{{0.25, 0.5}, {0.75, 0.5}});
        const std::uint32_t left = pieceOf(halves, 0);
        QVERIFY(!halves.isEmpty(left));
        QCOMPARE(halves.ringCount(left), 1u);
        QCOMPARE(halves.ringCorners(halves.outerRing(left)).size(), std::size_t{4});
        QCOMPARE(pieceArea(halves, left), 0.5);
        QVERIFY(pieceOutline(halves, left).holes.empty());
    }
    /// Its first ring would be that of the next piece, or lie beyond the last of all.
    void emptyPieceHasNoOutline_data() {
        QTest::addColumn<std::vector<Vec2>>("seeds");
        QTest::addColumn<std::size_t>("narrow");
        QTest::newRow("first") << std::vector<Vec2>{{0.04, 0.5}, {0.12, 0.5}, {0.88, 0.5}} << std::size_t{0};
        QTest::newRow("between") << std::vector<Vec2>{{0.3, 0.5}, {0.5, 0.5}, {0.62, 0.5}} << std::size_t{1};
        QTest::newRow("last") << std::vector<Vec2>{{0.12, 0.5}, {0.88, 0.5}, {0.96, 0.5}} << std::size_t{2};
    }
    void emptyPieceHasNoOutline() {
        QFETCH(std::vector<Vec2>, seeds);
        QFETCH(std::size_t, narrow);
        const Partition strips = shrunkStrips(seeds);
        const std::uint32_t empty = pieceOf(strips, narrow);
        QVERIFY(strips.isEmpty(empty));
        QCOMPARE(strips.ringCount(empty), 0u);
        QVERIFY(pieceOutline(strips, empty).outer.empty());
        QCOMPARE(pieceArea(strips, empty), 0.0);
        int edges = 0;
        forEachEdge(strips, empty, [&](std::uint32_t, std::uint32_t, std::uint32_t) { ++edges; });
        QCOMPARE(edges, 0);
        QCOMPARE(std::ranges::count(pieceAreas(strips), 0.0), 1);
    }
    void wholePartitionMayBeEmpty() {
        const Partition none =
            *shrunkPartition(*voronoiPartition(unitSquare(), std::vector<Vec2>{{0.25, 0.5}, {0.75, 0.5}}), 0.6);
        for (std::uint32_t piece = 0; piece < 2; ++piece) QVERIFY(pieceOutline(none, piece).outer.empty());
        QCOMPARE(pieceAreas(none), (std::vector<double>{0.0, 0.0}));
    }
};

RUBBLE_TEST(PartitionTest)
#include "PartitionTest.moc"
