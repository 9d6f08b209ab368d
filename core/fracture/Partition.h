#pragma once

#include "core/base/RawVector.h"
#include "core/fracture/Report.h"
#include "core/geometry/Polygon.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// An outline cut into pieces, and who touches whom: one planar subdivision. Pieces refer to shared corner points
/// by index, so neighbours share the end points of their common edge bit for bit, and no corner lies inside another
/// piece's edge. Voronoi cells, bricks and slices all come as this.
///
/// All flat arrays. Piece p has the rings [ringsOfPiece[p], ringsOfPiece[p + 1]), the outer one first
/// (counter-clockwise), then its holes (clockwise); rings of a piece may touch in single points. Ring r has the corners [cornersOfRing[r], cornersOfRing[r + 1]).
/// Corner c starts the edge to the next corner of its ring; `across[c]` is the piece behind that edge.
/// The pieces of one seed are consecutive, ordered by the cells of cut layers they lie in, then by their smallest corner (x, then
/// y), or by `partOfCell` where it is given; seeds stand in an order that is good for memory: use `pieceOfSeed` to go through them
/// by index.
struct Partition {
    Vec2 origin{0.0, 0.0};   // the points are relative to it, which keeps their digits far from zero
    RawVector<Vec2> points;  // m; not every one need be used

    RawVector<std::uint32_t> seedOfPiece;
    RawVector<std::uint32_t> ringsOfPiece;   // pieces + 1
    RawVector<std::uint32_t> cornersOfRing;  // rings + 1
    RawVector<std::uint32_t> corners;        // point of each corner
    RawVector<std::uint32_t> across;         // piece behind each corner's edge; kNone: the outline

    RawVector<std::uint32_t> pieceOfSeed;  // first piece of each input seed; kNone where it has none
    RawVector<std::uint32_t> cutLayers;    // ids of layers whose cuts give the pieces names; mostly none
    RawVector<std::uint32_t> cutCells;     // of each piece, one a cut layer: in which of its cells it lies
    RawVector<std::uint32_t> partOfCell;   // of each piece, see partOfCell(); empty: as the pieces stand
    double gap = 0.0;                      // m^2 of the outline that no piece covers
    std::vector<Report> reports;           // in seed order

    std::uint32_t pieceCount() const { return static_cast<std::uint32_t>(seedOfPiece.size()); }
    std::span<const std::uint32_t> cutCellsOf(std::uint32_t piece) const {
        return std::span(cutCells).subspan(piece * cutLayers.size(), cutLayers.size());
    }
    std::span<const std::uint32_t> ringCorners(std::uint32_t ring) const {
        return std::span(corners).subspan(cornersOfRing[ring], cornersOfRing[ring + 1] - cornersOfRing[ring]);
    }
};

/// Calls visit(from, to, across) for every edge of a piece, ring by ring: two points and the piece behind.
template <class Visit>
void forEachEdge(const Partition& partition, std::uint32_t piece, Visit visit) {
    for (std::uint32_t ring = partition.ringsOfPiece[piece]; ring < partition.ringsOfPiece[piece + 1]; ++ring) {
        const std::uint32_t begin = partition.cornersOfRing[ring], end = partition.cornersOfRing[ring + 1];
        for (std::uint32_t corner = begin; corner < end; ++corner) {
            const std::uint32_t next = corner + 1 < end ? corner + 1 : begin;
            visit(partition.corners[corner], partition.corners[next], partition.across[corner]);
        }
    }
}

/// Which part of its cell a piece is, as ids say it behind the cell's name, which is its seed's and those of the cells that cut
/// layers put it into: counted as the pieces stand, or as they stood before some of them were merged or split. kNone where it is
/// the only one of that name.
std::uint32_t partOfCell(const Partition& partition, std::uint32_t piece);

/// The piece as a polygon, in the outline's coordinates less `partition.origin` and less `centre`.
Polygon pieceOutline(const Partition& partition, std::uint32_t piece, Vec2 centre = {0.0, 0.0});
double pieceArea(const Partition& partition, std::uint32_t piece);

/// Whether one of the piece's rings runs from one point straight to another.
bool hasEdge(const Partition& partition, std::uint32_t piece, std::uint32_t from, std::uint32_t to);

/// A pair of touching pieces.
struct PieceContact {
    std::uint32_t piece = 0;
    double length = 0.0;  // m of shared edges
};
/// Whom a piece touches and along how much: ascending piece order, shorter lengths than `least` left out.
std::vector<PieceContact> contactsOf(const Partition& partition, std::uint32_t piece, double least);

}  // namespace rubble
