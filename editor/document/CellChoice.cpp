#include "editor/document/CellChoice.h"

#include "core/fracture/PatternPartition.h"
#include "core/fracture/VoronoiPartition.h"

namespace rubble {

namespace {

SeedId cellOf(const BakedPattern& pattern, std::uint32_t piece) {
    return cellId(pattern.partition, piece, pattern.seeds.ids);
}

}  // namespace

FragmentChoice::Seeds allCells(const BakedPattern& pattern) {
    FragmentChoice::Seeds all(pattern.seeds.ids.begin(), pattern.seeds.ids.end());
    for (std::uint32_t piece = 0; piece < pattern.partition.pieceCount(); ++piece) all.insert(cellOf(pattern, piece));
    return all;
}

FragmentChoice::Seeds otherCells(const BakedPattern& pattern, const FragmentChoice::Seeds& chosen) {
    FragmentChoice::Seeds others = allCells(pattern);
    for (const SeedId cell : chosen) others.erase(cell);
    return others;
}

FragmentChoice::Seeds withNeighbourCells(const BakedPattern& pattern, const FragmentChoice::Seeds& chosen) {
    FragmentChoice::Seeds all = chosen;
    const double least = leastSharedEdge(pattern);
    for (std::uint32_t piece = 0; piece < pattern.partition.pieceCount(); ++piece) {
        if (!chosen.contains(cellOf(pattern, piece))) continue;
        for (const PieceContact& contact : contactsOf(pattern.partition, piece, least)) {
            all.insert(cellOf(pattern, contact.piece));
        }
    }
    return all;
}

double leastSharedEdge(const BakedPattern& pattern) {
    return kLeastSharedEdge * boundsOf(pattern.asset->prism.outline.outer).diagonal();
}

}  // namespace rubble
