#include "core/fracture/pieces/PieceMerge.h"

#include "core/base/Assert.h"
#include "core/base/Index.h"
#include "core/geometry/polygon/Polygon.h"

#include <algorithm>
#include <array>
#include <map>

namespace rubble {
namespace {

/// An edge of one of the pieces.
struct PieceEdge {
    std::uint32_t piece;
    RingEdge edge;
};

/// Traces the boundary of a group: at the end of each boundary edge, goes on around the point, through the inner edges,
/// to the next boundary edge.
class BoundaryTracer {
public:
    BoundaryTracer(std::span<const PieceRings> pieces, std::span<const std::uint32_t> group,
                   std::span<const std::uint32_t> receivers)
        : m_pieces(pieces), m_group(group), m_receivers(receivers), m_isVisited(group.size()) {
        for (std::size_t member = 0; member < group.size(); ++member) {
            for (const PieceRing& ring : pieces[group[member]]) m_isVisited[member].emplace_back(ring.size(), false);
            indexIfLarge(group[member]);
        }
    }

    PieceRings run() {
        PieceRings boundary;
        for (const std::uint32_t piece : m_group) {
            for (std::size_t ring = 0; ring < m_pieces[piece].size(); ++ring) {
                for (std::size_t corner = 0; corner < m_pieces[piece][ring].size(); ++corner) {
                    const PieceEdge start{piece, {ring, corner}};
                    if (!isInner(start) && !visited(start)) boundary.push_back(ringFrom(start));
                }
            }
        }
        return boundary;
    }

private:
    PieceRing ringFrom(PieceEdge edge) {
        PieceRing ring;
        for (; !visited(edge); edge = nextOnBoundary(edge)) {
            visited(edge) = true;
            ring.push_back(cornerOf(edge));
        }
        return ring;
    }

    PieceEdge nextOnBoundary(PieceEdge edge) const {
        edge = nextInRing(edge);
        while (isInner(edge)) {
            const PieceCorner& corner = cornerOf(edge);
            edge =
                nextInRing({corner.neighbour, find(corner.neighbour, cornerOf(nextInRing(edge)).point, corner.point)});
        }
        return edge;
    }

    /// Indexes the edges of a piece with so many corners that findEdge() would be slow.
    void indexIfLarge(std::uint32_t piece) {
        constexpr std::size_t kMaxLinear = 64;
        std::size_t count = 0;
        for (const PieceRing& ring : m_pieces[piece]) count += ring.size();
        if (count <= kMaxLinear) return;
        auto& edges = m_largePieces[piece];
        for (std::size_t ring = 0; ring < m_pieces[piece].size(); ++ring) {
            const PieceRing& corners = m_pieces[piece][ring];
            for (std::size_t k = 0; k < corners.size(); ++k)
                edges.emplace(std::array{corners[k].point, corners[nextCorner(corners, k)].point}, RingEdge{ring, k});
        }
    }
    /// The edge of a piece from one point to another, which it has.
    RingEdge find(std::uint32_t piece, std::uint32_t from, std::uint32_t to) const {
        if (const auto large = m_largePieces.find(piece); large != m_largePieces.end())
            return large->second.at({from, to});
        const std::optional<RingEdge> edge = findEdge(m_pieces[piece], {from, to});
        RUBBLE_ASSERT(edge);
        return *edge;
    }

    PieceEdge nextInRing(PieceEdge edge) const {
        edge.edge.corner = nextCorner(m_pieces[edge.piece][edge.edge.ring], edge.edge.corner);
        return edge;
    }
    const PieceCorner& cornerOf(const PieceEdge& edge) const {
        return m_pieces[edge.piece][edge.edge.ring][edge.edge.corner];
    }
    /// Whether the edge lies between two pieces of the group.
    bool isInner(const PieceEdge& edge) const {
        const std::uint32_t neighbour = cornerOf(edge).neighbour;
        return neighbour != kNone && m_receivers[neighbour] == m_receivers[edge.piece];
    }
    std::vector<bool>::reference visited(const PieceEdge& edge) {
        const auto member = static_cast<std::size_t>(std::ranges::lower_bound(m_group, edge.piece) - m_group.begin());
        return m_isVisited[member][edge.edge.ring][edge.edge.corner];
    }

    std::span<const PieceRings> m_pieces;
    std::span<const std::uint32_t> m_group;
    std::span<const std::uint32_t> m_receivers;
    std::vector<std::vector<std::vector<bool>>> m_isVisited;  // of each member, ring and corner
    std::map<std::uint32_t, std::map<std::array<std::uint32_t, 2>, RingEdge>> m_largePieces;  // their edges {from, to}
};

double ringArea(const PieceRing& ring, std::span<const Vec2> points) {
    Ring positions;
    for (const PieceCorner& corner : ring) positions.push_back(points[corner.point]);
    return signedArea(positions);
}

}  // namespace

PieceRings mergedRings(std::span<const PieceRings> pieces, std::span<const std::uint32_t> group,
                       std::span<const std::uint32_t> receivers, std::span<const Vec2> points) {
    std::vector<PieceRings> parts = connectedParts(BoundaryTracer(pieces, group, receivers).run(), points);
    RUBBLE_ASSERT(!parts.empty());
    // The area is connected: what rounding gives the winding of a second part is a hole without width.
    const auto largest =
        std::ranges::max_element(parts, {}, [&](const PieceRings& rings) { return ringArea(rings[0], points); });
    std::iter_swap(parts.begin(), largest);
    PieceRings& rings = parts[0];
    for (std::size_t k = 1; k < parts.size(); ++k) rings.insert(rings.end(), parts[k].begin(), parts[k].end());
    return std::move(rings);
}

}  // namespace rubble
