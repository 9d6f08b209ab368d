#include "editor/document/CellSelection.h"

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

double minimumSharedEdge(const BakedPattern& pattern) {
    return kMinSharedEdge * boundsOf(pattern.asset->prism.outline.outer).diagonal();
}

}  // namespace rubble
