#include "core/fracture/voronoi/CellAssembly.h"

#include "tests/support/FaultOfSeed.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/TracedCells.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <cmath>

using namespace rubble;
using test::TracedCells;

namespace {

CellRange assembled(const TracedCells& cells, std::uint32_t firstSite, std::uint32_t endSite) {
    return assembleCells({cells.outline, cells.delaunay, cells.outgoing, cells.trace, cells.numbers, cells.frame,
                          cells.acuteCorners, cells.points},
                         firstSite, endSite);
}

CellRange assembled(const TracedCells& cells) { return assembled(cells, 0, cells.siteCount()); }

/// The area of the pieces of a site, m^2.
double areaOf(const TracedCells& cells, const CellRange& range, std::uint32_t site) {
    const std::vector<Ring> rings = cells.ringsOf(range.pieces);
    const auto ringsBefore = [&](std::uint32_t piece) { return piece == 0 ? 0 : range.pieces.pieceEnds[piece - 1]; };
    const std::uint32_t k = site - range.firstSite;
    double sum = 0.0;
    for (std::uint32_t ring = ringsBefore(range.firstPieces[k]); ring < ringsBefore(range.firstPieces[k + 1]); ++ring)
        sum += signedArea(rings[ring]);
    return sum;
}

}  // namespace

class CellAssemblyTest : public QObject {
    Q_OBJECT
private slots:
    void cellInsideIsWhole() {
        std::vector<Vec2> grid;
        for (int k = 0; k < 9; ++k) grid.push_back({2.0 + 4.0 * (k % 3), 2.0 + 4.0 * (k / 3)});
        const TracedCells cells({rectangle({0, 0}, {12, 12}), {}}, grid);
        const CellRange range = assembled(cells);
        QCOMPARE(range.firstPieces.back(), 9u);
        for (std::uint32_t site = 0; site < 9; ++site) QCOMPARE(areaOf(cells, range, site), 16.0);
    }
    void cellsOutsideAndInHolesHaveNoPiece() {
        std::vector<Vec2> grid;
        for (int k = 0; k < 25; ++k) grid.push_back({-6.0 + 4.0 * (k % 5), -6.0 + 4.0 * (k / 5)});
        // The cell of the seed in the middle, (2, 2), lies within the hole.
        const TracedCells cells({rectangle({-7, -7}, {11, 11}), {reversed(rectangle({-0.5, -0.5}, {4.5, 4.5}))}}, grid);
        const CellRange range = assembled(cells);
        const std::uint32_t middle = cells.siteOf(12);
        QCOMPARE(range.firstPieces[middle + 1], range.firstPieces[middle]);
        double sum = 0.0;
        for (std::uint32_t site = 0; site < 25; ++site) sum += areaOf(cells, range, site);
        QCOMPARE(sum, 18.0 * 18.0 - 25.0);
    }
    void coincidentCornersAreNoted() {
        const TracedCells cells(unitSquare(), {{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}});
        const CellRange range = assembled(cells);
        QVERIFY(!range.coincident.empty());  // the two corners in the middle
        for (const auto& [a, b] : range.coincident) {
            QCOMPARE(cells.points[a], Vec2(0.5, 0.5));
            QCOMPARE(cells.points[b], Vec2(0.5, 0.5));
        }
    }
    void vertexOnABisectorTouchesBothCells() {
        const Polygon outline{{{0, 0}, {0.5, 0.25}, {1, 0}, {1, 1}, {0, 1}}, {}};
        const TracedCells cells(outline, {{0.25, 0.5}, {0.75, 0.5}});
        const CellRange range = assembled(cells);
        QCOMPARE(range.touches.size(), std::size_t{1});  // of the cell that its arc is in
        QCOMPARE(cells.points[range.touches[0].point], Vec2(0.5, 0.25));
    }
    void rangesAreThoseOfTheWhole() {
        Random random(5);
        const TracedCells cells(combWithHole(), test::randomSeeds(random, 60, false));
        const std::uint32_t half = cells.siteCount() / 2;
        const CellRange whole = assembled(cells);
        const CellRange first = assembled(cells, 0, half), second = assembled(cells, half, cells.siteCount());
        QCOMPARE(second.firstSite, half);
        QCOMPARE(first.firstPieces.back() + second.firstPieces.back(), whole.firstPieces.back());
        for (std::uint32_t site = 0; site < cells.siteCount(); ++site)
            QCOMPARE(areaOf(cells, site < half ? first : second, site), areaOf(cells, whole, site));
    }
    void areasAreThoseOfHalfPlanes_data() {
        QTest::addColumn<bool>("isOnLattice");
        QTest::newRow("anywhere") << false;
        QTest::newRow("on a lattice") << true;
    }
    void areasAreThoseOfHalfPlanes() {
        QFETCH(bool, isOnLattice);
        for (std::uint64_t number = 1; number <= 60; ++number) {
            Random random(number);
            const TracedCells cells(combWithHole(), test::randomSeeds(random, 50, isOnLattice));
            const CellRange range = assembled(cells);
            for (std::uint32_t site = 0; site < cells.siteCount(); ++site) {
                QVERIFY2(std::abs(areaOf(cells, range, site) - cells.areaOfCell(site)) < 1e-11,  // of 64 m^2
                         qPrintable(faultOfSeed(number, "site " + std::to_string(site))));
            }
        }
    }
};

RUBBLE_TEST(CellAssemblyTest)
#include "CellAssemblyTest.moc"
