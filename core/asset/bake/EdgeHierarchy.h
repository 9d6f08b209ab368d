#pragma once

#include "core/asset/bake/Bake.h"
#include "core/geometry/search/BoxTree.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace rubble {

/// A piece of a fracture.
struct FracturePiece {
    std::uint32_t fracture, piece;
};

/// An edge of a piece as it is extruded, the `number`th in the order of forEachEdge().
struct PieceEdge {
    std::uint32_t fracture, piece, number;
    std::uint32_t from, to;   // points of the shapes
    std::uint32_t neighbour;  // the piece behind it; kNone: the outline of the fractured solid
};

/// The part of an edge along which one leaf piece lies, and that piece's own edge.
struct EdgeInterval {
    double from, to;  // m along the edge
    std::uint32_t fracture, piece, number;
};

/// The overlap of a piece's edge with an edge of the parent fragment.
struct EdgeOverlap {
    PieceEdge parent;
    double start;     // m along the parent's edge: where the piece's edge begins, may be negative
    double from, to;  // m along the parent's edge: the common part
};

/// The edges of a bake across its levels: the parent's edges that a piece's edge lies on, and the leaf pieces along an
/// edge. Borrows the bake.
class EdgeHierarchy {
public:
    /// Edges closer than `tolerance` (m) coincide. O(log n) for each edge of a piece and each overlap, for n edges of
    /// the parent.
    EdgeHierarchy(const Bake& bake, double tolerance);

    const Fragments& fragmentsOf(std::uint32_t fracture) const { return m_bake.fractures[fracture].fragments; }
    const Partition& shapesOf(std::uint32_t fracture) const { return fragmentsOf(fracture).extruded()->shapes(); }
    /// The origin of the shapes' points in the asset's frame.
    Vec2 originOf(std::uint32_t fracture) const;
    double lengthOf(const PieceEdge& edge) const;
    std::vector<PieceEdge> edgesOf(FracturePiece piece) const;
    std::vector<PieceEdge> edgesOf(std::uint32_t fragment) const;

    /// The overlaps with the parent's edges, in the direction of the edge; none for edges on the asset's outline.
    std::vector<EdgeOverlap> overlapsOf(const PieceEdge& edge) const;
    /// The leaf pieces along an edge, in its direction. There are no intervals where a gap between pieces ends.
    std::vector<EdgeInterval> intervalsOf(const PieceEdge& edge) const;

private:
    struct FragmentEdges {
        std::vector<PieceEdge> edges;
        BoxTree tree;  // of these, in the frame of their fracture
    };
    FragmentEdges indexedEdgesOf(std::uint32_t fragment) const;
    void addIntervals(std::uint32_t fracture);

    const Bake& m_bake;
    double m_tolerance;
    std::vector<std::optional<FragmentEdges>> m_parents;              // per fracture, of its parent; none of the whole
    std::vector<std::vector<std::vector<EdgeInterval>>> m_intervals;  // per fracture, one list per edge of its parent
};

}  // namespace rubble
