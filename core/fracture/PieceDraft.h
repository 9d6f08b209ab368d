#pragma once

#include "core/fracture/Partition.h"
#include "core/fracture/Pattern.h"
#include "core/fracture/PieceRings.h"

#include <vector>

namespace rubble {

/// A straight line.
struct Line {
    Vec2 point{0.0, 0.0};      // m
    Vec2 direction{1.0, 0.0};  // any length but zero
    bool operator==(const Line&) const = default;
};

/// A partition whose pieces are being merged and split: one planar subdivision all the time. A piece keeps its number; one
/// that has gone into another has no rings left, and new ones come behind the others.
class PieceDraft {
public:
    explicit PieceDraft(Partition partition);

    std::uint32_t count() const { return static_cast<std::uint32_t>(m_pieces.size()); }
    bool isThere(std::uint32_t piece) const { return !m_pieces[piece].rings.empty(); }
    /// Its name, see pieceName(Partition).
    std::string nameOf(std::uint32_t piece, std::span<const SeedId> seeds) const;
    /// Whether two pieces share an edge.
    bool areNeighbours(std::uint32_t piece, std::uint32_t other) const;

    /// Makes groups of pieces one: of each piece the one that it goes into, itself where it stays. A group must hang
    /// together by edges.
    void merge(std::span<const std::uint32_t> receivers);

    /// Cuts a piece along a line in the outline's coordinates, and says into how many pieces: 1 where the line misses it. The
    /// one with the smallest corner (x, then y) keeps its number; the parts are named by the free numbers of their cell.
    /// A line that comes nearer to a corner than points can be told apart is moved aside by as little.
    std::uint32_t split(std::uint32_t piece, const Line& line);

    /// The partition with these pieces, those of a seed ordered by their parts.
    Partition finished() &&;

private:
    struct Piece {
        PieceRings rings;
        std::uint32_t origin;  // the piece of the partition whose seed and cells it is named by
        std::uint32_t part;    // see partOfCell()
    };
    struct Edge {
        std::size_t ring;
        std::size_t corner;
    };
    Edge edgeOf(std::uint32_t piece, std::uint32_t from, std::uint32_t to) const;
    PieceRings boundaryOf(const std::vector<std::uint32_t>& group, std::span<const std::uint32_t> receivers) const;
    Line clearOfCorners(std::uint32_t piece, Line line) const;
    std::vector<std::uint32_t> addCrossings(std::uint32_t piece, const Line& line);
    std::vector<PieceRings> cutApart(std::uint32_t piece, const std::vector<std::uint32_t>& crossings);
    void takeParts(std::uint32_t piece, std::vector<PieceRings> parts);
    std::uint32_t seedOf(std::uint32_t piece) const { return m_partition.seedOfPiece[m_pieces[piece].origin]; }
    std::span<const std::uint32_t> cutCellsOf(std::uint32_t piece) const {
        return m_partition.cutCellsOf(m_pieces[piece].origin);
    }
    bool areNamesakes(std::uint32_t piece, std::uint32_t other) const;
    std::uint32_t freePart(std::uint32_t piece) const;

    Partition m_partition;  // its points, names and reports; the rest when finished
    std::vector<Piece> m_pieces;
};

}  // namespace rubble
