#include "core/asset/LevelContacts.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

namespace rubble {
namespace {

/// A straight edge of a partition that two of its pieces share.
struct CutEdge {
    std::size_t breaking = 0;  // its number in the bake
    std::uint32_t from = 0;    // this and the next: points of its partition, ascending
    std::uint32_t to = 0;
    auto operator<=>(const CutEdge&) const = default;
};

/// Where a fragment lies along such an edge.
struct Stretch {
    std::uint32_t fragment = 0;
    std::uint32_t side = 0;  // the one of the two pieces that it is, or is a part of
    double begin = 0.0;      // m from the edge's first point
    double end = 0.0;
};

struct Edge {
    Vec2 from{0.0, 0.0};  // m, in the asset's frame
    Vec2 to{0.0, 0.0};
};

double distanceTo(const Edge& edge, Vec2 point) {
    const Vec2 along = edge.to - edge.from;
    const double square = glm::dot(along, along);
    const double share = square > 0.0 ? std::clamp(glm::dot(point - edge.from, along) / square, 0.0, 1.0) : 0.0;
    return glm::distance(point, edge.from + share * along);
}

class CutStretches {
public:
    explicit CutStretches(const Bake& bake) : m_bake(bake) {}

    /// All of a fragment's edges: each lies along a cut of the breaking it comes from, or of one above; or it is outside.
    void add(std::uint32_t fragment) {
        forEachEdgeOf(fragment, [&](const CutEdge& cut, const Edge& edge, std::uint32_t across) {
            if (across != kNone) return put(fragment, fragment, cut, edge);
            const std::uint32_t parent = m_bake.breakings[cut.breaking].parent;
            if (parent != kNone) putAlongCutOf(parent, fragment, edge);
        });
    }

    std::vector<std::pair<std::uint32_t, std::uint32_t>> contacts() const {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
        for (const auto& [cut, stretches] : m_stretches) {
            const double least = m_bake.breakings[cut.breaking].fragments.leastEdge;
            for (std::size_t k = 0; k < stretches.size(); ++k) {
                for (std::size_t other = k + 1; other < stretches.size(); ++other) {
                    const Stretch &a = stretches[k], &b = stretches[other];
                    if (a.side == b.side || std::min(a.end, b.end) - std::max(a.begin, b.begin) <= least) continue;
                    if (breakingWith(a.fragment) == breakingWith(b.fragment)) continue;
                    pairs.push_back(std::minmax(a.fragment, b.fragment));
                }
            }
        }
        std::ranges::sort(pairs);
        pairs.erase(std::ranges::unique(pairs).begin(), pairs.end());
        return pairs;
    }

private:
    std::size_t breakingWith(std::uint32_t fragment) const {
        const auto behind = std::ranges::upper_bound(m_bake.breakings, fragment, {}, &BakedBreaking::first);
        return static_cast<std::size_t>(behind - m_bake.breakings.begin()) - 1;
    }

    Vec2 place(std::size_t breaking, std::uint32_t point) const {
        const Fragments& all = m_bake.breakings[breaking].fragments;
        return all.partition.points[point] + all.partition.origin + Vec2{all.origin};
    }

    /// Calls visit(cut, edge, across) for the edges of its piece and of thin pieces that went to it.
    template <class Visit>
    void forEachEdgeOf(std::uint32_t fragment, Visit visit) const {
        const std::size_t breaking = breakingWith(fragment);
        const Fragments& all = m_bake.breakings[breaking].fragments;
        const std::uint32_t index = fragment - m_bake.breakings[breaking].first;
        const auto visitPiece = [&](std::uint32_t piece) {
            forEachEdge(all.partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t across) {
                visit(CutEdge{breaking, std::min(from, to), std::max(from, to)},
                      Edge{place(breaking, from), place(breaking, to)}, across);
            });
        };
        visitPiece(all.pieceOfFragment[index]);
        for (const ThinPieceGift& gift : all.gifts) {
            if (gift.receiver != kNone && all.fragmentOfPiece[gift.receiver] == index) visitPiece(gift.thin);
        }
    }

    /// An edge on the outline of a fragment lies along the fragment's own edge that is nearest; where that is outside, too, along
    /// one of what the fragment is a piece of.
    void putAlongCutOf(std::uint32_t whole, std::uint32_t fragment, const Edge& edge) {
        const Vec2 middle = edge.from + 0.5 * (edge.to - edge.from);
        double nearest = std::numeric_limits<double>::infinity();
        CutEdge cut;
        std::uint32_t behind = kNone;
        forEachEdgeOf(whole, [&](const CutEdge& candidate, const Edge& along, std::uint32_t across) {
            const double distance = distanceTo(along, middle);
            if (distance < nearest) std::tie(nearest, cut, behind) = std::tuple(distance, candidate, across);
        });
        if (behind != kNone) return put(fragment, whole, cut, edge);
        const std::uint32_t parent = m_bake.breakings[cut.breaking].parent;
        if (parent != kNone) putAlongCutOf(parent, fragment, edge);
    }

    void put(std::uint32_t fragment, std::uint32_t side, const CutEdge& cut, const Edge& edge) {
        const Vec2 start = place(cut.breaking, cut.from), along = place(cut.breaking, cut.to) - start;
        const double length = glm::length(along);
        if (!(length > 0.0)) return;
        const double from = glm::dot(edge.from - start, along) / length, to = glm::dot(edge.to - start, along) / length;
        m_stretches[cut].push_back({fragment, side, std::min(from, to), std::max(from, to)});
    }

    const Bake& m_bake;
    std::map<CutEdge, std::vector<Stretch>> m_stretches;
};

}  // namespace

std::vector<std::pair<std::uint32_t, std::uint32_t>> contactsAcrossParents(const Bake& bake, std::uint32_t level) {
    CutStretches stretches(bake);
    for (const BakedBreaking& breaking : bake.breakings) {
        if (breaking.level > level) continue;
        for (std::uint32_t k = breaking.first; k < breaking.first + breaking.fragments.count(); ++k) {
            if (breaking.level == level || !bake.breakingOf(k)) stretches.add(k);
        }
    }
    return stretches.contacts();
}

}  // namespace rubble
