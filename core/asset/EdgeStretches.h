#pragma once

#include "core/asset/Bake.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// One edge of a piece as it is extruded: the `number`th in the order of forEachEdge().
struct PieceEdge {
    std::uint32_t breaking, piece, number;
    std::uint32_t from, to;  // points of the shapes
    std::uint32_t across;    // the piece behind it; kNone: the outline of what was broken
};

/// The part of an edge at which one piece lies that is not broken again, and that piece's own edge.
struct EdgeStretch {
    double from, to;  // m along the edge
    std::uint32_t breaking, piece, number;
};

/// How an edge of a piece lies on an edge of the fragment that it is a piece of.
struct EdgeOverlap {
    PieceEdge parent;
    double start;     // m along the parent's edge, where the piece's own begins: may lie before it
    double from, to;  // m along the parent's edge: what they share
};

/// The edges of a bake across its levels: which edge of a fragment those of its pieces lie on, and which pieces of the deepest levels
/// lie along an edge. The bake must stay where it is meanwhile.
class EdgeStretches {
public:
    /// What is not farther from an edge than `reach` (m) lies on it. O(edges of a fragment · edges of its pieces) for each
    /// fragment that is broken again.
    EdgeStretches(const Bake& bake, double reach);

    const Fragments& fragmentsOf(std::uint32_t breaking) const { return m_bake.breakings[breaking].fragments; }
    const Partition& shapesOf(std::uint32_t breaking) const { return fragmentsOf(breaking).shapes(); }
    /// That of the shapes' points, in the asset's frame.
    Vec2 originOf(std::uint32_t breaking) const;
    std::uint32_t breakingWith(std::uint32_t fragment) const;
    double lengthOf(const PieceEdge& edge) const;
    std::vector<PieceEdge> edgesOf(std::uint32_t breaking, std::uint32_t piece) const;
    std::vector<PieceEdge> edgesOf(std::uint32_t fragment) const;

    /// In the order in which the edge runs; none along the outline of the asset.
    std::vector<EdgeOverlap> overlapsOf(const PieceEdge& edge) const;
    /// In the order in which the edge runs. Nobody lies where a gap between pieces ends.
    std::vector<EdgeStretch> stretchesOf(const PieceEdge& edge) const;

private:
    std::vector<EdgeOverlap> overlapsOf(const PieceEdge& edge, const std::vector<PieceEdge>& parents) const;
    void takeStretches(std::uint32_t breaking);

    const Bake& m_bake;
    double m_reach;
    std::vector<std::vector<std::vector<EdgeStretch>>> m_below;  // of each breaking, a list an edge of what it broke
};

}  // namespace rubble
