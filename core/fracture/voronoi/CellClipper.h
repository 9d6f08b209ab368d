#pragma once

#include "core/fracture/voronoi/OutlineTrace.h"
#include "core/fracture/voronoi/PartitionPoints.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// A corner of a piece while a partition is being put together.
struct CellCorner {
    std::uint32_t point;
    std::uint32_t neighbour;  // site behind the edge that starts here; kNone: the outline
};

/// The pieces of a clipped cell: per piece its rings, the outer one first.
struct CellPieces {
    std::vector<CellCorner> corners;
    std::vector<std::uint32_t> ringEnds;   // in corners
    std::vector<std::uint32_t> pieceEnds;  // in ringEnds
    void clear();
};

/// Clips cells to the outline. Reuses its memory from cell to cell.
/// Source: Weiler, Atherton 1977, with exact signs and without degenerate cases.
class CellClipper {
public:
    CellClipper(const Delaunay& delaunay, const std::vector<std::uint32_t>& outgoing, const OutlineTrace& trace,
                PointNumbers numbers, std::span<const Vec2> points);

    /// The pieces of a cell that the outline enters, ordered by their smallest corner (x, then y).
    void clip(std::uint32_t site, CellPieces& pieces);

private:
    /// A point where the outline crosses the cell's boundary.
    struct BoundaryCrossing {
        std::uint32_t halfEdge;  // from the site, through the Voronoi edge that is crossed
        std::uint32_t position;  // of that edge, counter-clockwise around the cell
        std::uint32_t crossing;
        std::uint32_t arc;   // the one that leaves or enters here
        std::uint32_t exit;  // of an entry, the crossing where its arc leaves the cell
        bool isEntry;
        bool isVisited;
    };

    void collect(std::uint32_t site);
    bool areInOrder() const;
    void setPositions(std::uint32_t site);
    void sortCrossings(std::uint32_t site);
    void linkExits();
    void addPieceFrom(std::size_t crossing, CellPieces& pieces);
    void appendBoundaryArc(const BoundaryArc& arc, CellPieces& pieces) const;
    void appendCellBoundary(const BoundaryCrossing& exit, const BoundaryCrossing& entry, CellPieces& pieces) const;
    void appendCorners(std::uint32_t from, std::uint32_t to, CellPieces& pieces) const;
    void addHoles(CellPieces& pieces) const;

    const Delaunay& m_delaunay;
    PerturbedDiagram m_diagram;
    const std::vector<std::uint32_t>& m_outgoing;
    const OutlineTrace& m_trace;
    PointNumbers m_numbers;
    std::span<const Vec2> m_points;

    std::vector<BoundaryCrossing> m_crossings;  // counter-clockwise
    std::vector<std::uint32_t> m_rings;         // arcs that are whole rings
    std::vector<std::uint32_t> m_exits;         // by arc: the crossing where it leaves the cell
};

}  // namespace rubble
