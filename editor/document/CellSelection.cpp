#include "editor/document/CellSelection.h"

#include "core/asset/project/AssetShape.h"
#include "core/fracture/pattern/PatternPartition.h"
#include "core/fracture/voronoi/VoronoiPartition.h"

namespace rubble {

namespace {

SeedId cellOf(const BakedPattern& pattern, std::uint32_t piece) {
    return cellId(pattern.partition, piece, pattern.seeds.ids);
}

}  // namespace

FragmentSelection::Seeds allCells(const BakedPattern& pattern) {
    FragmentSelection::Seeds all(pattern.seeds.ids.begin(), pattern.seeds.ids.end());
    for (std::uint32_t piece = 0; piece < pattern.partition.pieceCount(); ++piece) all.insert(cellOf(pattern, piece));
    return all;
}

FragmentSelection::Seeds invertedCells(const BakedPattern& pattern, const FragmentSelection::Seeds& selected) {
    FragmentSelection::Seeds inverted = allCells(pattern);
    for (const SeedId cell : selected) inverted.erase(cell);
    return inverted;
}

FragmentSelection::Seeds withNeighbourCells(const BakedPattern& pattern, const FragmentSelection::Seeds& selected) {
    FragmentSelection::Seeds all = selected;
    const double minimum = minimumSharedEdge(pattern);
    for (std::uint32_t piece = 0; piece < pattern.partition.pieceCount(); ++piece) {
        if (!selected.contains(cellOf(pattern, piece))) continue;
        for (const PieceContact& contact : contactsOf(pattern.partition, piece, minimum)) {
            all.insert(cellOf(pattern, contact.piece));
        }
    }
    return all;
}

std::vector<bool> selectedPieces(Id asset, const Partition& partition, const Seeds& seeds,
                                 const FragmentSelection& selection, const FragmentPath& parent) {
    const std::string prefix = std::to_string(asset) + "/" + (parent.empty() ? std::string() : parent + "/");
    const FragmentSelection::Seeds cells = selection.seedsOf(parent);
    std::vector<bool> isSelected(partition.pieceCount(), false);
    for (std::uint32_t piece = 0; !cells.empty() && piece < partition.pieceCount(); ++piece) {
        const SeedId cell = cellId(partition, piece, seeds.ids);
        if (!cells.contains(cell)) continue;
        const auto id = [&] { return prefix + pieceName(partition, piece, seeds.ids); };
        isSelected[piece] = !selection.ids || selection.contains(parent, cell, id());
    }
    return isSelected;
}

std::vector<bool> selectedPieces(const BakedPattern& pattern, const FragmentSelection& selection) {
    return selectedPieces(pattern.asset->id, pattern.partition, pattern.seeds, selection, pattern.parent);
}

double minimumSharedEdge(const BakedPattern& pattern) {
    return kMinSharedEdge * planeBoundsOf(*pattern.asset).diagonal();
}

}  // namespace rubble
