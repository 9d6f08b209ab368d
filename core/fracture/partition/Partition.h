#pragma once

#include "core/base/Assert.h"
#include "core/base/Diagnostic.h"
#include "core/base/UninitializedVector.h"
#include "core/fracture/partition/PointEdge.h"
#include "core/geometry/polygon/Polygon.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// An outline cut into pieces, with their neighbours: one planar subdivision. Pieces refer to shared corner points by
/// index, so neighbours share the end points of their common edge bit for bit, and no corner lies inside another
/// piece's edge. Voronoi cells, bricks and slices are all partitions.
///
/// All arrays are flat. Piece p has the rings [ringsOfPiece[p], ringsOfPiece[p + 1]): the outer one first
/// (counter-clockwise), then its holes (clockwise); rings of a piece may touch at single points. Ring r has the corners
/// [cornersOfRing[r], cornersOfRing[r + 1]). Corner c starts the edge to the next corner of its ring; `neighbours[c]`
/// is the piece on the other side of that edge.
///
/// Every piece of a subdivision has an outer ring. Only where pieces were shrunk (shrunkPartition()), some may be
/// empty: these have no rings, and `ringsOfPiece[p]` is the first ring of a later piece, or none. So the outer ring is
/// found by outerRing(), after isEmpty() where pieces may be empty.
///
/// The pieces of one seed are consecutive: ordered by their cells in cut layers, then by their smallest corner (x, then
/// y), or by `partOfCell` if it is given. Seeds are ordered for cache locality: use `pieceOfSeed` to visit them by
/// index.
struct Partition {
    Vec2 origin{0.0, 0.0};             // the points are relative to it, which keeps their digits far from zero
    UninitializedVector<Vec2> points;  // m; some may be unused

    UninitializedVector<std::uint32_t> seedOfPiece;
    UninitializedVector<std::uint32_t> ringsOfPiece;   // pieces + 1
    UninitializedVector<std::uint32_t> cornersOfRing;  // rings + 1
    UninitializedVector<std::uint32_t> corners;        // point of each corner
    UninitializedVector<std::uint32_t> neighbours;     // piece behind each corner's edge; kNone: the outline

    UninitializedVector<std::uint32_t> pieceOfSeed;  // first piece of each input seed; kNone where it has none
    UninitializedVector<std::uint32_t> cutLayers;    // ids of the layers whose cuts name pieces; mostly none
    UninitializedVector<std::uint32_t> cutCells;     // per piece, its cell in each cut layer
    UninitializedVector<std::uint32_t> partOfCell;   // of each piece, see partOfCell(); empty: by piece order
    double gap = 0.0;                                // m² of the outline that no piece covers
    std::vector<Diagnostic> diagnostics;             // in seed order

    std::uint32_t pieceCount() const { return static_cast<std::uint32_t>(seedOfPiece.size()); }
    std::span<const std::uint32_t> cutCellsOf(std::uint32_t piece) const {
        return std::span(cutCells).subspan(piece * cutLayers.size(), cutLayers.size());
    }
    /// Whether nothing is left of a piece: it has no rings.
    bool isEmpty(std::uint32_t piece) const { return ringCount(piece) == 0; }
    std::uint32_t ringCount(std::uint32_t piece) const {
        RUBBLE_ASSERT(piece + std::size_t{1} < ringsOfPiece.size());
        return ringsOfPiece[piece + 1] - ringsOfPiece[piece];
    }
    /// The outer ring of a piece that is not empty.
    std::uint32_t outerRing(std::uint32_t piece) const {
        RUBBLE_ASSERT(!isEmpty(piece));
        return ringsOfPiece[piece];
    }
    std::span<const std::uint32_t> ringCorners(std::uint32_t ring) const {
        RUBBLE_ASSERT(ring + std::size_t{1} < cornersOfRing.size());
        return std::span(corners).subspan(cornersOfRing[ring], cornersOfRing[ring + 1] - cornersOfRing[ring]);
    }
};

/// Whether two partitions have the same pieces, with the same numbers and corners. Merges and splits may keep all
/// points.
bool areSamePieces(const Partition& a, const Partition& b);

/// Calls visit(from, to, neighbour) for every edge of a piece, ring by ring: two points and the piece behind the edge.
template <class Visit>
void forEachEdge(const Partition& partition, std::uint32_t piece, Visit visit) {
    for (std::uint32_t ring = partition.ringsOfPiece[piece]; ring < partition.ringsOfPiece[piece + 1]; ++ring) {
        const std::uint32_t begin = partition.cornersOfRing[ring], end = partition.cornersOfRing[ring + 1];
        for (std::uint32_t corner = begin; corner < end; ++corner) {
            const std::uint32_t next = corner + 1 < end ? corner + 1 : begin;
            visit(partition.corners[corner], partition.corners[next], partition.neighbours[corner]);
        }
    }
}

/// The number of a piece among those that share its seed and its cells in cut layers, as used in piece names: counted
/// in piece order, or in the order before some pieces were merged or split. kNone: the only one.
std::uint32_t partOfCell(const Partition& partition, std::uint32_t piece);

/// The piece as a polygon, in the outline's coordinates minus `partition.origin` and minus `centre`; a polygon without
/// corners if the piece is empty.
Polygon pieceOutline(const Partition& partition, std::uint32_t piece, Vec2 centre = {0.0, 0.0});
double pieceArea(const Partition& partition, std::uint32_t piece);
std::vector<double> pieceAreas(const Partition& partition);  // of all pieces

/// What a piece is part of, for sentences: "the cell of seed 7", or "the outline" where it has no seed.
std::string cellText(const Partition& partition, std::uint32_t piece);

/// Whether the piece has an edge.
bool hasEdge(const Partition& partition, std::uint32_t piece, PointEdge edge);

/// A neighbouring piece and the length of the common boundary.
struct PieceContact {
    std::uint32_t piece = 0;
    double length = 0.0;  // m
};
/// The neighbours of a piece, ascending; those that share less than `minLength` metres are left out.
std::vector<PieceContact> contactsOf(const Partition& partition, std::uint32_t piece, double minLength);

}  // namespace rubble
