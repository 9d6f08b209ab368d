#include "core/io/fracture/CellList.h"

#include <algorithm>
#include <map>
#include <utility>

namespace rubble {
namespace {

/// Returns a piece in the input's coordinates. Subtracting the origin from the outline's points was exact, so adding it
/// restores their bits.
Polygon toInput(Polygon local, Vec2 origin) {
    for (Vec2& corner : local.outer) corner += origin;
    for (Ring& hole : local.holes) {
        for (Vec2& corner : hole) corner += origin;
    }
    return local;
}

/// Returns the seeds whose shared edges with the pieces [first, end) have a total length above `minSharedEdge`.
std::vector<std::uint32_t> neighboursOf(const Partition& partition, std::uint32_t first, std::uint32_t end,
                                        double minSharedEdge) {
    std::map<std::uint32_t, double> shared;  // length of common edges by seed, m
    for (std::uint32_t piece = first; piece < end; ++piece) {
        for (const PieceContact& contact : contactsOf(partition, piece, 0.0)) {
            shared[partition.seedOfPiece[contact.piece]] += contact.length;
        }
    }
    std::vector<std::uint32_t> neighbours;
    for (const auto& [seed, length] : shared) {
        if (length > minSharedEdge) neighbours.push_back(seed);
    }
    return neighbours;
}

Cell cellOf(const Partition& partition, std::uint32_t seed, double minSharedEdge) {
    Cell cell{.seed = seed};
    const std::uint32_t first = partition.pieceOfSeed[seed];
    std::uint32_t piece = first;
    Vec2 moment(0.0);
    for (; piece < partition.pieceCount() && partition.seedOfPiece[piece] == seed; ++piece) {
        Polygon local = pieceOutline(partition, piece);
        const double pieceArea = area(local);
        cell.area += pieceArea;
        moment += pieceArea * centroid(local);
        cell.pieces.push_back(toInput(std::move(local), partition.origin));
    }
    // The area may underflow to zero; then any corner is the centroid.
    cell.centroid = cell.area > 0.0 ? partition.origin + moment / cell.area : cell.pieces[0].outer[0];
    cell.neighbours = neighboursOf(partition, first, piece, minSharedEdge);
    return cell;
}

}  // namespace

std::vector<Cell> cellList(const Partition& partition, double minSharedEdge) {
    std::vector<Cell> cells;
    for (std::uint32_t seed = 0; seed < partition.pieceOfSeed.size(); ++seed) {
        if (partition.pieceOfSeed[seed] != kNone) cells.push_back(cellOf(partition, seed, minSharedEdge));
    }
    return cells;
}

}  // namespace rubble
