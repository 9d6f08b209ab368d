#include "core/fracture/voronoi/CellClipper.h"

#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/TracedCells.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <cmath>

using namespace rubble;
using test::TracedCells;

namespace {

CellPieces clippedCell(const TracedCells& cells, std::uint32_t site) {
    CellClipper clipper(cells.delaunay, cells.outgoing, cells.trace, cells.numbers, cells.points);
    CellPieces pieces;
    clipper.clip(site, pieces);
    return pieces;
}

double areaOf(const TracedCells& cells, const CellPieces& pieces) {
    double sum = 0.0;
    for (const Ring& ring : cells.ringsOf(pieces)) sum += signedArea(ring);
    return sum;
}

}  // namespace

class CellClipperTest : public QObject {
    Q_OBJECT
private slots:
    void halfOfASquareHasOneEdgeToTheOtherHalf() {
        const TracedCells cells(unitSquare(), {{0.25, 0.5}, {0.75, 0.5}});
        const CellPieces left = clippedCell(cells, cells.siteOf(0));
        QCOMPARE(left.pieceEnds, (std::vector<std::uint32_t>{1}));
        QCOMPARE(left.ringEnds, (std::vector<std::uint32_t>{4}));
        QCOMPARE(areaOf(cells, left), 0.5);
        for (const CellCorner& corner : left.corners) {
            // Counter-clockwise, the edge to the other half starts at its lower end.
            const bool isLowerEnd = cells.points[corner.point] == Vec2(0.5, 0.0);
            QCOMPARE(corner.neighbour, isLowerEnd ? cells.siteOf(1) : kNone);
        }
    }
    void cellInTwoPartsIsSortedByTheirSmallestCorners() {
        // The tips of both ends of an L are nearer to a seed beyond the corner that it leaves out: x + y > 2.5.
        const TracedCells cells(lShape(), {{2.5, 2.5}, {0.0, 0.0}});
        const CellPieces ends = clippedCell(cells, cells.siteOf(0));
        QCOMPARE(ends.pieceEnds, (std::vector<std::uint32_t>{1, 2}));
        const std::vector<Ring> rings = cells.ringsOf(ends);
        QCOMPARE(signedArea(rings[0]), 0.125);
        QCOMPARE(signedArea(rings[1]), 0.125);
        QVERIFY(boundsOf(rings[0]).max.x <= 1.0);
        QVERIFY(boundsOf(rings[1]).min.x >= 1.0);
        QCOMPARE(areaOf(cells, clippedCell(cells, cells.siteOf(1))), 2.75);
    }
    void outlineInOneCellIsThePiece() {
        const TracedCells cells(squareRing(), {{2.0, 2.0}, {100.0, 100.0}});
        const CellPieces whole = clippedCell(cells, cells.siteOf(0));
        QCOMPARE(whole.pieceEnds, (std::vector<std::uint32_t>{2}));  // one piece of two rings
        QCOMPARE(signedArea(cells.ringsOf(whole)[0]), 16.0);
        QCOMPARE(signedArea(cells.ringsOf(whole)[1]), -4.0);
        for (const CellCorner& corner : whole.corners) QCOMPARE(corner.neighbour, kNone);
    }
    void holeInAWholeCellIsItsSecondRing() {
        std::vector<Vec2> grid;
        for (int k = 0; k < 9; ++k) grid.push_back({2.0 + 4.0 * (k % 3), 2.0 + 4.0 * (k / 3)});
        const TracedCells cells({rectangle({0, 0}, {12, 12}), {reversed(rectangle({5, 5}, {6, 7}))}}, grid);
        const CellPieces middle = clippedCell(cells, cells.siteOf(4));
        const std::vector<Ring> rings = cells.ringsOf(middle);
        QCOMPARE(middle.pieceEnds, (std::vector<std::uint32_t>{2}));
        QCOMPARE(signedArea(rings[0]), 16.0);
        QCOMPARE(signedArea(rings[1]), -2.0);
    }
    void memoryIsReusedFromCellToCell() {
        const TracedCells cells(lShape(), {{2.0, 2.0}, {0.0, 0.0}});
        CellClipper clipper(cells.delaunay, cells.outgoing, cells.trace, cells.numbers, cells.points);
        CellPieces pieces;
        for (const std::uint32_t seed : {0u, 1u, 0u}) {
            clipper.clip(cells.siteOf(seed), pieces);
            QCOMPARE(areaOf(cells, pieces), seed == 0 ? 1.0 : 2.0);
        }
    }
    void areasAreThoseOfHalfPlanes_data() {
        QTest::addColumn<bool>("isOnLattice");
        QTest::newRow("anywhere") << false;
        QTest::newRow("on a lattice") << true;
    }
    void areasAreThoseOfHalfPlanes() {
        QFETCH(bool, isOnLattice);
        for (std::uint64_t number = 1; number <= 100; ++number) {
            Random random(number);
            const TracedCells cells(combWithHole(), test::randomSeeds(random, 30, isOnLattice));
            for (std::uint32_t site = 0; site < cells.siteCount(); ++site) {
                if (cells.trace.firstArc[site] == kNone) continue;
                const double found = areaOf(cells, clippedCell(cells, site));
                QVERIFY2(std::abs(found - cells.areaOfCell(site)) < 1e-11,  // of 64 m^2; both are rounded
                         qPrintable(faultOfSeed(number, "site " + std::to_string(site))));
            }
        }
    }
};

RUBBLE_TEST(CellClipperTest)
#include "CellClipperTest.moc"
