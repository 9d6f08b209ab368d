#include "editor/canvas/painting/BondMarks.h"

#include "core/structure/strength/BondCapacities.h"
#include "core/structure/strength/StrengthMap.h"
#include "editor/canvas/painting/FragmentEdges.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace rubble {

namespace {

/// A property of fragments as one of their pieces; thin pieces are those of the fragment that has their mass.
std::vector<bool> ofPieces(const Fragments& fragments, const std::vector<bool>& ofFragments) {
    std::vector<bool> found(fragments.fragmentOfPiece.size(), false);
    for (std::size_t piece = 0; piece < found.size(); ++piece) {
        const std::uint32_t fragment = fragments.fragmentOfPiece[piece];
        found[piece] = fragment != kNone && ofFragments[fragment];
    }
    return found;
}

}  // namespace

BondMarker::BondMarker(std::shared_ptr<const Bake> bake, std::uint32_t fracture)
    : m_bake(std::move(bake)), m_fracture(fracture) {}

std::unique_ptr<BondMarker> BondMarker::of(const std::shared_ptr<const Bake>& bake, const DrawablePattern& pattern) {
    const Fragments* fragments = bake ? fragmentsWithin(*bake, pattern.baked().parent) : nullptr;
    if (!fragments || fragments->partition.points != pattern.partition().points) return nullptr;
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
    if (showsStrengths) {
        if (m_bonds.empty()) findEdges();
        marks.edges = edges(asset, neverBreaks);
    }
    return marks;
}

double BondMarker::levelStrengthIn(const Asset& asset) const { return levelStrength(asset, *m_bake, m_fracture); }

std::uint32_t BondMarker::bondBetween(std::uint32_t piece, std::uint32_t neighbour) const {
    const auto [first, second] =
        std::minmax(fragments().fragmentOfPiece[piece], fragments().fragmentOfPiece[neighbour]);
    const auto key = [](const Bond& bond) { return std::pair(bond.first, bond.second); };
    const auto found = std::ranges::lower_bound(m_bonds, std::pair(first, second), {}, key);
    const bool isFound = found != m_bonds.end() && key(*found) == std::pair(first, second);
    return isFound ? static_cast<std::uint32_t>(found - m_bonds.begin()) : kNone;
}

/// The bonds and their edges, each once.
void BondMarker::findEdges() {
    m_bonds = bondsOf(fragments());
    const Partition& partition = fragments().partition;
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
        forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
            if (neighbour == kNone || neighbour < piece) return;
            const std::uint32_t bond = bondBetween(piece, neighbour);
            if (bond == kNone) return;
            const Vec2 origin = partition.origin;
            m_edges.push_back({{origin + partition.points[from], origin + partition.points[to]}, bond});
        });
    }
}

std::vector<BondEdge> BondMarker::edges(const Asset& asset, const std::vector<bool>& neverBreaks) const {
    const StrengthMap map(asset);
    const double level = levelStrengthIn(asset);
    std::vector<BondEdge> edges;
    edges.reserve(m_edges.size());
    for (const auto& [edge, index] : m_edges) {
        const Bond& bond = m_bonds[index];
        edges.push_back(edge);
        edges.back().factor = neverBreaks[bond.first] && neverBreaks[bond.second]
                                  ? std::numeric_limits<double>::infinity()
                                  : level * map.at(Vec2{bond.centroid});
    }
    return edges;
}

}  // namespace rubble
