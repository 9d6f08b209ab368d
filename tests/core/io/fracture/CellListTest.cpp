#include "core/io/fracture/CellList.h"

#include "core/fracture/voronoi/VoronoiPartition.h"
#include "tests/support/TestProgram.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

using namespace rubble;

namespace {

using Indices = std::vector<std::uint32_t>;

std::vector<Cell> cellsOf(const Polygon& outline, const std::vector<Vec2>& seeds, double least = 1e-9) {
    const Result<Partition> partition = voronoiPartition(outline, seeds);
    return partition ? cellList(*partition, least) : std::vector<Cell>();
}

/// A U of 3 x 2 m whose arms are 1 m wide.
Polygon uShape() {
    return {{{0.0, 0.0}, {3.0, 0.0}, {3.0, 2.0}, {2.0, 2.0}, {2.0, 1.0}, {1.0, 1.0}, {1.0, 2.0}, {0.0, 2.0}}, {}};
}

}  // namespace

class CellListTest : public QObject {
    Q_OBJECT
private slots:
    void cellsAreInSeedOrder() {
        const std::vector<Cell> cells = cellsOf(unitSquare(), {{0.75, 0.5}, {0.25, 0.5}});
        QCOMPARE(cells.size(), std::size_t{2});
        QCOMPARE(cells[0].seed, 0u);
        QCOMPARE(cells[0].area, 0.5);
        QCOMPARE(cells[0].centroid, Vec2(0.75, 0.5));
        QCOMPARE(cells[1].centroid, Vec2(0.25, 0.5));
        QCOMPARE(cells[0].neighbours, Indices{1});
        QCOMPARE(cells[1].neighbours, Indices{0});
    }
    void seedsWithoutACellAreLeftOut() {
        const std::vector<Cell> cells = cellsOf(unitSquare(), {{9.0, 0.5}, {0.5, 0.5}, {0.5, 0.5}});
        QCOMPARE(cells.size(), std::size_t{1});
        QCOMPARE(cells[0].seed, 1u);
        QVERIFY(cells[0].neighbours.empty());
    }
    void cellsThatShareOnlyACornerAreNotNeighbours() {
        const std::vector<Cell> cells = cellsOf(unitSquare(), {{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}});
        QCOMPARE(cells[0].neighbours, (Indices{1, 2}));
        QCOMPARE(cells[3].neighbours, (Indices{1, 2}));
    }
    void neighboursShareMoreThanTheMinimum() {
        const std::vector<Vec2> seeds = {{0.25, 0.5}, {0.75, 0.5}};
        QCOMPARE(cellsOf(unitSquare(), seeds, 0.99)[0].neighbours, Indices{1});
        QVERIFY(cellsOf(unitSquare(), seeds, 1.0)[0].neighbours.empty());
    }
    /// The cell of the upper seed, between the arms, consists of the ends of both: two pieces.
    void cellCutApartHasSeveralPieces() {
        const std::vector<Cell> cells = cellsOf(uShape(), {{1.5, 0.5}, {1.5, 2.5}});
        QCOMPARE(cells.size(), std::size_t{2});
        QCOMPARE(cells[1].pieces.size(), std::size_t{2});
        QCOMPARE(cells[1].area, 1.0);
        QCOMPARE(cells[1].centroid, Vec2(1.5, 1.75));
        QCOMPARE(cells[1].neighbours, Indices{0});
    }
    void sharedLengthsOfPiecesAreAdded() {
        const std::vector<Vec2> seeds = {{1.5, 0.5}, {1.5, 2.5}};
        QCOMPARE(cellsOf(uShape(), seeds, 1.5)[1].neighbours, Indices{0});
        QVERIFY(cellsOf(uShape(), seeds, 2.0)[1].neighbours.empty());
    }
    void pointsOfTheOutlineKeepTheirBits() {
        const Ring ring = {{1e6 + 0.1, 0.3}, {1e6 + 0.7, 0.3}, {1e6 + 0.7, 0.9}, {1e6 + 0.1, 0.9}};
        const std::vector<Cell> cells = cellsOf({ring, {}}, {{1e6 + 0.4, 0.5}});
        QCOMPARE(cells[0].pieces[0].outer, ring);
    }
    void holesRunClockwise() {
        const std::vector<Cell> cells = cellsOf(squareRing(), {{0.5, 0.5}});
        QCOMPARE(cells[0].pieces[0].holes.size(), std::size_t{1});
        QVERIFY(signedArea(cells[0].pieces[0].holes[0]) < 0.0);
        QCOMPARE(cells[0].area, 12.0);
        QCOMPARE(cells[0].centroid, Vec2(2.0, 2.0));
    }
};

RUBBLE_TEST(CellListTest)
#include "CellListTest.moc"
