#include "core/asset/bake/NeighboursAcrossParents.h"

#include "core/asset/bake/SolidNeighbours.h"
#include "core/geometry/predicates/SegmentDistance.h"
#include "core/geometry/search/BoxTree.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

namespace rubble {
namespace {

/// A straight edge of a partition between two of its pieces.
struct CutEdge {
    std::size_t fracture = 0;  // its number in the bake
    std::uint32_t from = 0;    // this and the next: points of its partition, ascending
    std::uint32_t to = 0;
    auto operator<=>(const CutEdge&) const = default;
};

/// The part of a cut edge along which a fragment lies.
struct Interval {
    std::uint32_t fragment = 0;
    std::uint32_t side = 0;  // the one of the two pieces that it is or descends from
    double begin = 0.0;      // m from the edge's first point
    double end = 0.0;
};

struct Edge {
    Vec2 from{0.0, 0.0};  // m, in the asset's frame
    Vec2 to{0.0, 0.0};
};

/// An edge of a fragment, and the piece behind it: kNone on the outline of the fractured solid.
struct FragmentEdge {
    CutEdge cut;
    Edge edge;
    std::uint32_t neighbour = kNone;
};

/// The edges of a fragment in a spatial index.
class FragmentEdges {
public:
    explicit FragmentEdges(std::vector<FragmentEdge> edges) : m_edges(std::move(edges)), m_tree(boxesOf(m_edges)) {}

    /// The edge nearest to a point, the first of equally near ones.
    const FragmentEdge& nearestTo(Vec2 point) const {
        double nearest = std::numeric_limits<double>::infinity();
        std::uint32_t found = 0;
        m_tree.visitNear(Vec3(point, 0.0), [&](std::uint32_t k) {
            const double distance = distanceToSegment(point, m_edges[k].edge.from, m_edges[k].edge.to);
            if (distance < nearest || (distance == nearest && k < found)) {
                nearest = distance;
                found = k;
            }
            return nearest;
        });
        return m_edges[found];
    }

private:
    static std::vector<Box3> boxesOf(const std::vector<FragmentEdge>& edges) {
        std::vector<Box3> boxes;
        for (const FragmentEdge& edge : edges) boxes.push_back(boxOf(edge.edge.from, edge.edge.to));
        return boxes;
    }

    std::vector<FragmentEdge> m_edges;
    BoxTree m_tree;
};

class CutIntervals {
public:
    explicit CutIntervals(const Bake& bake) : m_bake(bake) {
        for (const BakedFracture& fracture : bake.fractures) {
            const ExtrudedPieces& pieces = *fracture.fragments.extruded();
            for (const MassTransfer& transfer : pieces.massTransfers) {
                if (transfer.receiver == kNone) continue;
                const std::uint32_t fragment = pieces.fragmentOfPiece[transfer.receiver];
                if (fragment != kNone) m_thinPieces.emplace_back(fracture.first + fragment, transfer.thin);
            }
        }
        std::ranges::stable_sort(m_thinPieces, {}, &ThinPiece::first);
    }

    /// Adds all edges of a fragment: each lies along a cut of its fracture or of one above, or on the outline.
    void add(std::uint32_t fragment) {
        forEachEdgeOf(fragment, [&](const CutEdge& cut, const Edge& edge, std::uint32_t neighbour) {
            if (neighbour != kNone) return addInterval(fragment, fragment, cut, edge);
            const std::uint32_t parent = m_bake.fractures[cut.fracture].parent;
            if (parent != kNone) addAlongCutOf(parent, fragment, edge);
        });
    }

    std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours() {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
        for (auto& [cut, intervals] : m_intervals) {
            const double least = m_bake.fractures[cut.fracture].fragments.extruded()->minSharedEdge;
            std::ranges::sort(intervals, {}, &Interval::begin);
            for (std::size_t k = 0; k < intervals.size(); ++k) {
                for (std::size_t other = k + 1; other < intervals.size(); ++other) {
                    const Interval &a = intervals[k], &b = intervals[other];
                    if (a.end - b.begin <= least) break;
                    if (a.side == b.side || std::min(a.end, b.end) - b.begin <= least) continue;
                    if (m_bake.fractureContaining(a.fragment) == m_bake.fractureContaining(b.fragment)) continue;
                    pairs.push_back(std::minmax(a.fragment, b.fragment));
                }
            }
        }
        std::ranges::sort(pairs);
        pairs.erase(std::ranges::unique(pairs).begin(), pairs.end());
        return pairs;
    }

private:
    using ThinPiece = std::pair<std::uint32_t, std::uint32_t>;  // the fragment that got its mass, and the piece

    Vec2 pointOf(std::size_t fracture, std::uint32_t point) const {
        const Fragments& all = m_bake.fractures[fracture].fragments;
        const Partition& partition = all.extruded()->partition;
        return partition.points[point] + partition.origin + Vec2{all.origin};
    }

    /// Calls visit(cut, edge, neighbour) for the edges of its piece and of thin pieces that went to it.
    template <class Visit>
    void forEachEdgeOf(std::uint32_t fragment, Visit visit) const {
        const std::size_t fracture = m_bake.fractureContaining(fragment);
        const ExtrudedPieces& all = *m_bake.fractures[fracture].fragments.extruded();
        const std::uint32_t index = fragment - m_bake.fractures[fracture].first;
        const auto visitPiece = [&](std::uint32_t piece) {
            forEachEdge(all.partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
                visit(CutEdge{fracture, std::min(from, to), std::max(from, to)},
                      Edge{pointOf(fracture, from), pointOf(fracture, to)}, neighbour);
            });
        };
        visitPiece(all.pieceOfFragment[index]);
        for (const auto& [receiver, thin] : std::ranges::equal_range(m_thinPieces, fragment, {}, &ThinPiece::first))
            visitPiece(thin);
    }

    const FragmentEdges& edgesOf(std::uint32_t ancestor) {
        const auto known = m_ancestors.find(ancestor);
        if (known != m_ancestors.end()) return known->second;
        std::vector<FragmentEdge> edges;
        forEachEdgeOf(ancestor, [&](const CutEdge& cut, const Edge& edge, std::uint32_t neighbour) {
            edges.push_back({cut, edge, neighbour});
        });
        return m_ancestors.emplace(ancestor, FragmentEdges(std::move(edges))).first->second;
    }

    /// An edge on the outline of `ancestor` lies along the nearest edge of `ancestor`; if that is on the outline of its
    /// parent, along an edge of the parent.
    void addAlongCutOf(std::uint32_t ancestor, std::uint32_t fragment, const Edge& edge) {
        const Vec2 middle = edge.from + 0.5 * (edge.to - edge.from);
        const FragmentEdge& along = edgesOf(ancestor).nearestTo(middle);
        if (along.neighbour != kNone) return addInterval(fragment, ancestor, along.cut, edge);
        const std::uint32_t parent = m_bake.fractures[along.cut.fracture].parent;
        if (parent != kNone) addAlongCutOf(parent, fragment, edge);
    }

    void addInterval(std::uint32_t fragment, std::uint32_t side, const CutEdge& cut, const Edge& edge) {
        const Vec2 start = pointOf(cut.fracture, cut.from), along = pointOf(cut.fracture, cut.to) - start;
        const double length = glm::length(along);
        if (!(length > 0.0)) return;
        const double from = glm::dot(edge.from - start, along) / length, to = glm::dot(edge.to - start, along) / length;
        m_intervals[cut].push_back({fragment, side, std::min(from, to), std::max(from, to)});
    }

    const Bake& m_bake;
    std::map<CutEdge, std::vector<Interval>> m_intervals;
    std::map<std::uint32_t, FragmentEdges> m_ancestors;  // by fragment
    std::vector<ThinPiece> m_thinPieces;                 // ascending fragments
};

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> neighboursAcrossParents(const Bake& bake, std::uint32_t level) {
    std::vector<std::uint32_t> fragments;
    for (const BakedFracture& fracture : bake.fractures) {
        if (fracture.level > level) continue;
        for (std::uint32_t k = fracture.first; k < fracture.first + fracture.fragments.count(); ++k) {
            if (fracture.level == level || !bake.fractureOf(k)) fragments.push_back(k);
        }
    }
    if (fragments.empty()) return {};
    if (bake.fractures[0].fragments.solid()) return solidNeighbours(bake, fragments);
    CutIntervals intervals(bake);
    for (const std::uint32_t fragment : fragments) intervals.add(fragment);
    return intervals.neighbours();
}

}  // namespace rubble
