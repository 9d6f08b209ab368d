#pragma once

#include "core/fracture/partition/Partition.h"
#include "core/fracture/pattern/Pattern.h"
#include "core/fracture/pieces/PieceSplit.h"

#include <vector>

namespace rubble {

/// A partition whose pieces are being merged and split; it is one planar subdivision at all times. Pieces keep their
/// numbers: one that is merged into another has no rings left, and new ones are added at the end.
class PieceDraft {
public:
    explicit PieceDraft(Partition partition);

    std::uint32_t count() const { return static_cast<std::uint32_t>(m_rings.size()); }
    /// Whether a piece has not been merged into another one.
    bool exists(std::uint32_t piece) const { return !m_rings[piece].empty(); }
    /// The piece's name, see pieceName(Partition).
    std::string nameOf(std::uint32_t piece, std::span<const SeedId> seeds) const;
    /// Whether two pieces share an edge.
    bool areNeighbours(std::uint32_t piece, std::uint32_t other) const;

    /// Merges groups of pieces. `receivers`: for each piece, the piece that it is merged into, or the piece itself. The
    /// pieces of a group must be connected by edges.
    void merge(std::span<const std::uint32_t> receivers);

    /// Splits a piece along a line in the outline's coordinates. Returns the number of parts: 1 if the line misses it.
    /// The part with the smallest corner (x, then y) keeps the piece's number; the parts get free part numbers of their
    /// cell. A line too close to a corner is moved, see clearOfCorners().
    std::uint32_t split(std::uint32_t piece, const Line& line);

    /// The partition of these pieces, those of a seed ordered by part number.
    Partition finished() &&;

private:
    struct Name {
        std::uint32_t source;  // the piece of the partition that has the same seed and cells
        std::uint32_t part;    // see partOfCell()
    };
    std::vector<std::uint32_t> addCrossings(std::uint32_t piece, const Line& line);
    void replaceByParts(std::uint32_t piece, std::vector<PieceRings> parts);
    std::uint32_t seedOf(std::uint32_t piece) const { return m_partition.seedOfPiece[m_names[piece].source]; }
    std::span<const std::uint32_t> cutCellsOf(std::uint32_t piece) const {
        return m_partition.cutCellsOf(m_names[piece].source);
    }
    bool areInSameCell(std::uint32_t piece, std::uint32_t other) const;
    std::uint32_t freePart(std::uint32_t piece) const;
    std::vector<std::uint32_t> finalOrder() const;

    Partition m_partition;            // its points, names and reports; the other arrays are outdated
    std::vector<PieceRings> m_rings;  // of each piece
    std::vector<Name> m_names;        // of each piece
};

}  // namespace rubble
