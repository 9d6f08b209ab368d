// Tests core/fracture/kinds/JitteredGrid.cpp and core/fracture/sampling/PairIndex.h.
#include "core/fracture/pattern/Pattern.h"
#include "core/fracture/sampling/PairIndex.h"
#include "tests/support/TestProgram.h"
#include "tests/support/fracture/LayerSeeds.h"
#include "tests/support/geometry/Outlines.h"

#include <QTest>

#include <map>

using namespace rubble;

namespace {

Result<Seeds> triedGrid(const JitteredGrid& grid, const Polygon& outline) { return layerSeeds(grid, outline, 5); }

std::map<std::uint32_t, Vec2> gridSeeds(const JitteredGrid& grid, const Polygon& outline) {
    return positionsByIndex(triedGrid(grid, outline).value());
}

}  // namespace

class JitteredGridTest : public QObject {
    Q_OBJECT
private slots:
    void withoutJitterSeedsAreAtCellCentres() {
        const Polygon bar{rectangle({1.0, 2.0}, {5.0, 4.0}), {}};
        const Seeds seeds = triedGrid({.columns = 2, .rows = 1, .jitter = 0.0}, bar).value();
        QCOMPARE(seeds.positions, (std::vector<Vec2>{{2.0, 3.0}, {4.0, 3.0}}));
    }
    void jitteredSeedsStayInTheirCells() {
        const auto seeds = gridSeeds({.columns = 5, .rows = 8, .jitter = 1.0}, unitSquare());
        QCOMPARE(seeds.size(), std::size_t{40});
        for (std::uint32_t column = 0; column < 5; ++column) {
            for (std::uint32_t row = 0; row < 8; ++row) {
                const Vec2 seed = seeds.at(pairIndex(column, row));
                QCOMPARE(static_cast<std::uint32_t>(seed.x * 5.0), column);
                QCOMPARE(static_cast<std::uint32_t>(seed.y * 8.0), row);
            }
        }
    }
    void addedColumnsAndRowsKeepIndicesAndPositions() {
        const auto few = gridSeeds({.columns = 3, .rows = 4}, unitSquare());
        const auto many = gridSeeds({.columns = 6, .rows = 12}, unitSquare());
        for (const auto& [index, seed] : few) {
            // The same fraction of a cell of half the width and a third of the height.
            const Vec2 other = many.at(index);
            QVERIFY(std::abs(other.x * 2.0 - seed.x) < 1e-12 && std::abs(other.y * 3.0 - seed.y) < 1e-12);
        }
    }
    void gridByCellSizeIsCentred() {
        // 1.05 m hold five cells of 0.2 m with 2.5 cm left at both ends; 0.32 m hold two, which extend 4 cm beyond.
        const Polygon bar{rectangle({0.0, 0.0}, {1.05, 0.32}), {}};
        const auto seeds =
            gridSeeds({.cells = GridCells::Size, .cellWidth = 0.2, .cellHeight = 0.2, .jitter = 0.0}, bar);
        QCOMPARE(seeds.size(), std::size_t{10});
        const Vec2 first = seeds.at(0), last = seeds.at(pairIndex(4, 1));
        QVERIFY(std::abs(first.x - 0.125) < 1e-12 && std::abs(first.y - 0.06) < 1e-12);
        QVERIFY(std::abs(last.x - 0.925) < 1e-12 && std::abs(last.y - 0.26) < 1e-12);
    }
    void seedsInHolesAreOmittedExceptInBoundingBox() {
        // Of 4 x 4 cells of a metre the central four are in the hole.
        QCOMPARE(gridSeeds({.columns = 4, .rows = 4}, squareRing()).size(), std::size_t{12});
        const JitteredGrid all{.columns = 4, .rows = 4, .domain = ScatterDomain::BoundingBox};
        QCOMPARE(gridSeeds(all, squareRing()).size(), std::size_t{16});
    }
    void tooManyCellsAreRejected() {
        const Result<Seeds> fine =
            triedGrid({.cells = GridCells::Size, .cellWidth = 1e-5, .cellHeight = 1.0}, unitSquare());
        QVERIFY(!fine);
        QCOMPARE(fine.error().code, ErrorCode::Limit);
        QCOMPARE(fine.error().message,
                 std::string("Layer 1 has 100000 cells along one side, but 10000 is the maximum."));
        const Result<Seeds> many = triedGrid({.columns = 10'000, .rows = 1'001}, unitSquare());
        QVERIFY(!many);
        QCOMPARE(many.error().message, std::string("Layer 1 brings the pattern above 10000000 seeds."));
        QVERIFY(
            triedGrid({.cells = GridCells::Size, .cellWidth = 1e-320, .cellHeight = 1.0}, unitSquare()).error().code ==
            ErrorCode::Limit);
    }
    void pairIndicesAreConsecutiveAndAscending() {
        std::uint32_t expected = 0;
        for (const IndexPair pair : pairsBelow(30, 30)) QCOMPARE(pair.index(), expected++);
        QCOMPARE(expected, 900u);
        for (const auto& [firsts, seconds] : {std::pair{1u, 50u}, {50u, 1u}, {7u, 12u}, {12u, 7u}, {0u, 3u}}) {
            const std::vector<IndexPair> pairs = pairsBelow(firsts, seconds);
            QCOMPARE(pairs.size(), std::size_t{firsts} * seconds);
            for (std::size_t k = 1; k < pairs.size(); ++k) QVERIFY(pairs[k - 1].index() < pairs[k].index());
        }
    }
};

RUBBLE_TEST(JitteredGridTest)
#include "JitteredGridTest.moc"
