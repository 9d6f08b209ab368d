#pragma once

#include "core/fracture/OutlineTrace.h"
#include "core/fracture/PartitionPoints.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// A corner of a piece while a partition is being put together.
struct CellCorner {
    std::uint32_t point;
    std::uint32_t across;  // site behind the edge that starts here; kNone: the outline
};

/// The pieces of one cell that the outline enters: per piece its rings, the outer one first.
struct CellPieces {
    std::vector<CellCorner> corners;
    std::vector<std::uint32_t> ringEnds;   // in corners
    std::vector<std::uint32_t> pieceEnds;  // in ringEnds
    void clear();
};

/// Cuts cells along the outline's passages: the face of the two to the left of the outline. Keeps its memory between cells.
/// Source: Weiler, Atherton 1977, with exact signs and no degenerate case.
class CellCutter {
public:
    CellCutter(const Delaunay& delaunay, const std::vector<std::uint32_t>& outgoing, const OutlineTrace& trace,
               PointNumbers numbers, std::span<const Vec2> points);

    /// The pieces of a cell with at least one passage, ordered by their smallest corner (x, then y).
    void cut(std::uint32_t site, CellPieces& pieces);

private:
    /// A place on the cell's boundary where the outline crosses it.
    struct Mark {
        std::uint32_t halfEdge;  // from the site, through the Voronoi edge that is crossed
        std::uint32_t place;     // of that edge counter-clockwise around the cell
        std::uint32_t crossing;
        std::uint32_t passage;  // which leaves here, or enters here
        bool isEntry;
        bool isDone;
    };

    void collect(std::uint32_t site);
    bool areInOrder() const;
    void placeMarks(std::uint32_t site);
    void sortMarks(std::uint32_t site);
    void followFrom(std::size_t mark, CellPieces& pieces);
    void appendPassage(const OutlinePassage& passage, CellPieces& pieces) const;
    void appendBoundary(const Mark& exit, const Mark& entry, CellPieces& pieces) const;
    void appendArc(std::uint32_t from, std::uint32_t to, CellPieces& pieces) const;
    void addHoles(CellPieces& pieces) const;

    const Delaunay& m_delaunay;
    PerturbedDiagram m_diagram;
    const std::vector<std::uint32_t>& m_outgoing;
    const OutlineTrace& m_trace;
    PointNumbers m_numbers;
    std::span<const Vec2> m_points;

    std::vector<Mark> m_marks;            // counter-clockwise
    std::vector<std::uint32_t> m_closed;  // passages that are whole rings
};

}  // namespace rubble
