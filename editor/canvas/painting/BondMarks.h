#pragma once

#include "core/structure/bonds/FaceEdges.h"
#include "editor/canvas/painting/DrawablePattern.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace rubble {

/// An edge between two cells whose fragments are bonded.
struct BondEdge {
    Vec2 from{0.0};  // m, in the frame of the pattern, as `to`
    Vec2 to{0.0};
    double factor = 1.0;  // of the bond's strength; infinite: it never breaks
    bool operator==(const BondEdge&) const = default;
};

/// What the canvas marks of an asset that breaks as bonded.
struct BondMarks {
    std::vector<bool> isAnchored;        // of each piece
    std::vector<bool> neverBreaks;       // of each piece
    std::vector<BondEdge> edges;         // empty unless strengths are shown
    std::vector<Colour> clusterColours;  // of each piece, see clusterColours(); empty: there are no clusters
    bool showsStrengths = false;
    bool operator==(const BondMarks&) const = default;
};

/// Finds how the bonds between the fragments of a displayed pattern hold. Keeps what does not depend on how the asset
/// is bonded.
class BondMarker {
public:
    BondMarker(std::shared_ptr<const Bake> bake, std::uint32_t fracture);
    /// That of the fracture whose fragments are the pieces of a pattern; null if the bake has none, or not yet.
    static std::unique_ptr<BondMarker> of(const std::shared_ptr<const Bake>& bake, const DrawablePattern& pattern);

    /// Those of a state of the baked asset; factors are those of its levels and of places.
    BondMarks marks(const Asset& asset, bool showsStrengths);
    /// Level::bondStrength of the fracture, see levelStrength().
    double levelStrengthIn(const Asset& asset) const;

private:
    const Fragments& fragments() const;
    std::vector<BondEdge> edges(const Asset& asset, const std::vector<bool>& neverBreaks) const;
    const std::vector<Colour>& coloursByCluster(const Asset& asset);

    std::shared_ptr<const Bake> m_bake;
    std::uint32_t m_fracture;   // index
    std::vector<Bond> m_bonds;  // of the fragments; empty until strengths are shown, as m_edges
    std::vector<FaceEdge> m_edges;
    std::vector<FragmentCluster> m_clusters;  // of the colours
    std::vector<Colour> m_clusterColours;     // of each piece
};

}  // namespace rubble
