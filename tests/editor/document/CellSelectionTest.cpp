#include "editor/document/CellSelection.h"

#include "core/fracture/pattern/PatternPartition.h"
#include "core/fracture/voronoi/VoronoiPartition.h"
#include "tests/support/TestProgram.h"
#include "tests/support/asset/Projects.h"

#include <algorithm>

using namespace rubble;

namespace {

/// A row of four cells, named 3.0 to 3.3.
BakedPattern rowOfCells() {
    BakedPattern pattern;
    pattern.asset = std::make_shared<const Asset>(
        boxAsset(2, 3, PlacedSeeds{{{0, {0.125, 0.5}}, {1, {0.375, 0.5}}, {2, {0.625, 0.5}}, {3, {0.875, 0.5}}}}));
    pattern.seeds = *seedsOf(pattern.asset->pattern, pattern.asset->prism().outline);
    pattern.triangulation = *triangulate(pattern.seeds.positions);
    pattern.partition = *voronoiPartition(pattern.asset->prism().outline, pattern.triangulation);
    return pattern;
}

}  // namespace

class CellSelectionTest : public QObject {
    Q_OBJECT
private slots:
    void invertedAndAllCells() {
        const BakedPattern pattern = rowOfCells();
        QCOMPARE(allCells(pattern), (FragmentSelection::Seeds{{3, 0}, {3, 1}, {3, 2}, {3, 3}}));
        QCOMPARE(invertedCells(pattern, {{3, 1}, {3, 2}}), (FragmentSelection::Seeds{{3, 0}, {3, 3}}));
    }
    void neighboursShareAnEdge() {
        QCOMPARE(withNeighbourCells(rowOfCells(), {{3, 0}}), (FragmentSelection::Seeds{{3, 0}, {3, 1}}));
    }
    void piecesOfSelectedSeedsAreSelected() {
        const BakedPattern pattern = rowOfCells();
        const std::vector<bool> isSelected = selectedPieces(pattern, {.seeds = {{3, 1}, {3, 2}}});
        for (std::uint32_t piece = 0; piece < pattern.partition.pieceCount(); ++piece) {
            const SeedId cell = cellId(pattern.partition, piece, pattern.seeds.ids);
            QCOMPARE(isSelected[piece], cell.index == 1 || cell.index == 2);
        }
    }
    /// Where only some fragments of a cell are selected.
    void namesLimitTheSelection() {
        const BakedPattern pattern = rowOfCells();
        const FragmentSelection selection{.seeds = {{3, 1}, {3, 2}}, .ids = FragmentSelection::Ids{"2/3.1"}};
        QCOMPARE(std::ranges::count(selectedPieces(pattern, selection), true), 1);
    }
    void nothingIsSelectedInAnotherFragment() {
        BakedPattern pattern = rowOfCells();
        pattern.parent = "5.0";
        QCOMPARE(std::ranges::count(selectedPieces(pattern, {.seeds = {{3, 1}}}), true), 0);
        QCOMPARE(std::ranges::count(selectedPieces(pattern, {.seeds = {{3, 1}}, .parent = "5.0"}), true), 1);
    }
};

RUBBLE_TEST(CellSelectionTest)
#include "CellSelectionTest.moc"
