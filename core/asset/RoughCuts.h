#pragma once

#include "core/asset/EdgeStretches.h"

#include <memory>
#include <vector>

namespace rubble {

/// The cuts of a bake, on all its levels, as they are drawn where they are rough. Bake and asset must stay where they are meanwhile.
///
/// A cut is displaced across itself by noise, stretch by stretch: noise vanishes where the cut meets other cuts, of any level, and the
/// outline. A corner is moved by at most a share of how far it is from all other edges of the two pieces that lie at the stretch and
/// are not broken again, less a step: rough edges of a piece meet nowhere but in their ends, which stay. A fragment that
/// is broken is as rough as its pieces are together. Beside a gap each piece is rough by itself, and stands out by less than half of it.
class RoughCuts {
public:
    /// O(edges of a fragment · edges of its pieces) for each fragment that is broken again; O(1) where cuts are straight.
    RoughCuts(const Bake& bake, const Asset& asset);

    /// What is put into the edges of a fragment, in its frame: nothing into an edge that is no cut, or shorter than two bumps' steps. Fragments
    /// on either side of a cut get the same points bit for bit, before either subtracts its centre; pieces of either get them
    /// up to the rounding to their frames. O(edges of the two pieces · steps) an edge.
    EdgeCorners cornersOf(std::uint32_t fragment) const;

private:
    struct Corner {
        double along;  // m along its edge
        Vec2 place;    // as the points of the edge's shapes
    };
    struct Cut;

    std::vector<Corner> cornersOn(const PieceEdge& edge, double from, double to) const;
    std::vector<Corner> cornersOnParent(const PieceEdge& edge, double from, double to) const;
    Cut cutAt(const PieceEdge& edge) const;
    std::vector<Corner> cornersOfCut(const Cut& cut, double from, double to) const;
    std::vector<Corner> cornersBetween(const Cut& cut, double from, double to) const;
    double displacementAt(Vec2 place, const Cut& cut, double room, double step) const;
    Vec2 placeOn(const Cut& cut, double along) const;
    double roomBeside(const EdgeStretch& stretch, const Cut& cut, Vec2 place) const;
    double roomToSurface(const Cut& cut, Vec2 place) const;

    const Roughness& m_roughness;
    double m_diameter = 0.0;                       // m, of the asset
    std::vector<double> m_gaps;                    // m, of each breaking
    std::unique_ptr<const EdgeStretches> m_edges;  // none where cuts are straight
};

}  // namespace rubble
