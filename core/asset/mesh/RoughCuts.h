#pragma once

#include "core/asset/bake/EdgeHierarchy.h"
#include "core/asset/mesh/FragmentMesh.h"

#include <memory>
#include <vector>

namespace rubble {

/// The rough cuts of a bake, on all levels. Borrows bake and asset.
///
/// A cut is displaced along its normal by noise, interval by interval; the noise vanishes where the cut meets other
/// cuts of any level, and the outline. A point is displaced by at most a fraction of its distance, less one step, to
/// the other edges of the two leaf pieces at the interval: rough edges of a piece meet at their end points only, and
/// these stay fixed. The edges of a fractured fragment follow those of its children. At a gap, each piece is displaced
/// independently and extends into less than half of the gap.
class RoughCuts {
public:
    /// O(edges of a fragment · edges of its pieces) per fractured fragment; O(1) without roughness.
    RoughCuts(const Bake& bake, const Asset& asset);

    /// The points to insert into the edges of a fragment, in its frame; none for edges that are not cuts or are shorter
    /// than two steps. Both sides of a cut get the same points bit for bit, before each subtracts its centre; their
    /// children get the same points, up to rounding in their own frames. O(edges of the two pieces · steps) per edge.
    EdgeCorners cornersOf(std::uint32_t fragment) const;

private:
    struct Corner {
        double along;   // m along its edge
        Vec2 position;  // in the frame of the edge's shapes
    };
    struct Cut;

    std::vector<Corner> cornersOn(const PieceEdge& edge, double from, double to) const;
    std::vector<Corner> cornersOnParent(const PieceEdge& edge, double from, double to) const;
    Cut cutAt(const PieceEdge& edge) const;
    std::vector<Corner> cornersOfCut(const Cut& cut, double from, double to) const;
    std::vector<Corner> cornersBetween(const Cut& cut, double from, double to) const;
    double displacementAt(Vec2 position, const Cut& cut, double clearance, double step) const;
    Vec2 pointOn(const Cut& cut, double along) const;
    double clearanceIn(const EdgeInterval& interval, const Cut& cut, Vec2 position) const;
    double clearanceToSurface(const Cut& cut, Vec2 position) const;

    const Roughness& m_roughness;
    double m_diameter = 0.0;                       // m, of the asset
    std::vector<double> m_gaps;                    // m, per fracture
    std::unique_ptr<const EdgeHierarchy> m_edges;  // null without roughness
};

}  // namespace rubble
