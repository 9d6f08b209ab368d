#include "editor/canvas/painting/BondMarks.h"

#include "core/structure/capacity/BondCapacities.h"
#include "core/structure/capacity/StrengthMap.h"
#include "core/structure/clusters/ClusterColours.h"
#include "editor/canvas/painting/FragmentEdges.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace rubble {

namespace {

/// A property of fragments as one of their pieces; thin pieces are those of the fragment that has their mass.
std::vector<bool> ofPieces(const Fragments& fragments, const std::vector<bool>& ofFragments) {
    const UninitializedVector<std::uint32_t>& fragmentOfPiece = fragments.extruded()->fragmentOfPiece;
    std::vector<bool> found(fragmentOfPiece.size(), false);
    for (std::size_t piece = 0; piece < found.size(); ++piece) {
        const std::uint32_t fragment = fragmentOfPiece[piece];
        found[piece] = fragment != kNone && ofFragments[fragment];
    }
    return found;
}

}  // namespace

BondMarker::BondMarker(std::shared_ptr<const Bake> bake, std::uint32_t fracture)
    : m_bake(std::move(bake)), m_fracture(fracture) {}

std::unique_ptr<BondMarker> BondMarker::of(const std::shared_ptr<const Bake>& bake, const DrawablePattern& pattern) {
    const Fragments* fragments = bake ? fragmentsWithin(*bake, pattern.baked().parent) : nullptr;
    if (!fragments || !fragments->extruded() || !areSamePieces(fragments->extruded()->partition, pattern.partition()))
        return nullptr;
    const auto found = std::ranges::find(bake->fractures, fragments,
                                         [](const BakedFracture& fracture) { return &fracture.fragments; });
    return std::make_unique<BondMarker>(bake, static_cast<std::uint32_t>(found - bake->fractures.begin()));
}

const Fragments& BondMarker::fragments() const { return m_bake->fractures[m_fracture].fragments; }

BondMarks BondMarker::marks(const Asset& asset, bool showsStrengths) {
    const std::vector<bool> neverBreaks = neverBreaking(asset, *m_bake, m_fracture);
    std::vector<bool> isAnchored(fragments().count(), false);
    for (const std::uint32_t fragment : anchoredFragments(asset, *m_bake, m_fracture)) isAnchored[fragment] = true;
    BondMarks marks{ofPieces(fragments(), isAnchored), ofPieces(fragments(), neverBreaks)};
    marks.showsStrengths = showsStrengths;
    marks.clusterColours = coloursByCluster(asset);
    if (showsStrengths) {
        if (m_bonds.empty()) {
            m_bonds = bondsOf(fragments());
            m_edges = faceEdges(fragments(), m_bonds);
        }
        marks.edges = edges(asset, neverBreaks);
    }
    return marks;
}

double BondMarker::levelStrengthIn(const Asset& asset) const { return levelStrength(asset, *m_bake, m_fracture); }

std::vector<BondEdge> BondMarker::edges(const Asset& asset, const std::vector<bool>& neverBreaks) const {
    const StrengthMap map(asset);
    const double level = levelStrengthIn(asset);
    std::vector<BondEdge> edges;
    edges.reserve(m_edges.size());
    for (const FaceEdge& edge : m_edges) {
        const Bond& bond = m_bonds[edge.bond];
        const bool canBreak = !neverBreaks[bond.first] || !neverBreaks[bond.second];
        const double factor = canBreak ? level * map.at(Vec2{bond.centroid}) : std::numeric_limits<double>::infinity();
        edges.push_back({edge.from, edge.to, factor});
    }
    return edges;
}

/// Kept while clusters stay: strokes that are being painted do not change them.
const std::vector<Colour>& BondMarker::coloursByCluster(const Asset& asset) {
    if (asset.bonding.clusters == m_clusters) return m_clusterColours;
    m_clusters = asset.bonding.clusters;
    m_clusterColours.clear();
    if (m_clusters.empty()) return m_clusterColours;
    const std::vector<Colour> colours = clusterColours(asset, *m_bake, m_fracture);
    for (const std::uint32_t fragment : fragments().extruded()->fragmentOfPiece)
        m_clusterColours.push_back(fragment == kNone ? kUnclusteredColour : colours[fragment]);
    return m_clusterColours;
}

}  // namespace rubble
