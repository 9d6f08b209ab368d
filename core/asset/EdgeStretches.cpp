#include "core/asset/EdgeStretches.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace rubble {
namespace {

/// What the stretch from `a` to `b` shares with an edge that begins at (0, 0): the part is not farther than `reach` from it.
std::optional<EdgeOverlap> overlapOf(Vec2 a, Vec2 b, Vec2 edge, double reach) {
    const double length = glm::length(edge);
    if (!(length > 0.0)) return std::nullopt;
    const Vec2 along = edge / length, left = perpendicular(along);
    const double start = glm::dot(a, along), end = glm::dot(b, along);
    const double from = std::max(start, 0.0), to = std::min(end, length);
    if (!(to - from > reach)) return std::nullopt;
    const double distance = glm::dot(a, left), slope = glm::dot(b - a, left) / (end - start);
    const auto lies = [&](double place) { return std::abs(distance + (place - start) * slope) <= reach; };
    if (!lies(from) || !lies(to)) return std::nullopt;
    return EdgeOverlap{{}, start, from, to};
}

}  // namespace

EdgeStretches::EdgeStretches(const Bake& bake, double reach)
    : m_bake(bake), m_reach(reach), m_below(bake.breakings.size()) {
    for (std::size_t k = bake.breakings.size(); k-- > 1;) takeStretches(static_cast<std::uint32_t>(k));
}

Vec2 EdgeStretches::originOf(std::uint32_t breaking) const {
    return shapesOf(breaking).origin + Vec2{fragmentsOf(breaking).origin};
}

std::uint32_t EdgeStretches::breakingWith(std::uint32_t fragment) const {
    const auto above = std::ranges::upper_bound(m_bake.breakings, fragment, {}, &BakedBreaking::first);
    return static_cast<std::uint32_t>(above - m_bake.breakings.begin()) - 1;
}

double EdgeStretches::lengthOf(const PieceEdge& edge) const {
    const Partition& shapes = shapesOf(edge.breaking);
    return glm::distance(shapes.points[edge.from], shapes.points[edge.to]);
}

std::vector<PieceEdge> EdgeStretches::edgesOf(std::uint32_t breaking, std::uint32_t piece) const {
    std::vector<PieceEdge> edges;
    forEachEdge(shapesOf(breaking), piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t across) {
        edges.push_back({breaking, piece, static_cast<std::uint32_t>(edges.size()), from, to, across});
    });
    return edges;
}

std::vector<PieceEdge> EdgeStretches::edgesOf(std::uint32_t fragment) const {
    const std::uint32_t breaking = breakingWith(fragment);
    return edgesOf(breaking, fragmentsOf(breaking).pieceOfFragment[fragment - m_bake.breakings[breaking].first]);
}

std::vector<EdgeOverlap> EdgeStretches::overlapsOf(const PieceEdge& edge) const {
    const std::uint32_t parent = m_bake.breakings[edge.breaking].parent;
    return parent == kNone ? std::vector<EdgeOverlap>() : overlapsOf(edge, edgesOf(parent));
}

std::vector<EdgeOverlap> EdgeStretches::overlapsOf(const PieceEdge& edge, const std::vector<PieceEdge>& parents) const {
    std::vector<EdgeOverlap> overlaps;
    const std::uint32_t above = parents.front().breaking;
    const RawVector<Vec2>&points = shapesOf(edge.breaking).points, &pointsAbove = shapesOf(above).points;
    const Vec2 shift = originOf(edge.breaking) - originOf(above);
    for (const PieceEdge& parent : parents) {
        const Vec2 begin = pointsAbove[parent.from];
        const Vec2 from = points[edge.from] + shift - begin, to = points[edge.to] + shift - begin;
        std::optional<EdgeOverlap> overlap = overlapOf(from, to, pointsAbove[parent.to] - begin, m_reach);
        if (!overlap) continue;
        overlap->parent = parent;
        overlaps.push_back(*overlap);
    }
    const auto begin = [](const EdgeOverlap& overlap) { return overlap.from - overlap.start; };
    std::ranges::sort(overlaps, {}, begin);
    return overlaps;
}

std::vector<EdgeStretch> EdgeStretches::stretchesOf(const PieceEdge& edge) const {
    const Fragments& fragments = fragmentsOf(edge.breaking);
    const std::uint32_t fragment = fragments.fragmentOfPiece[edge.piece];
    const bool isFragment = fragment != kNone && fragments.pieceOfFragment[fragment] == edge.piece;
    const BakedBreaking* pieces =
        isFragment ? m_bake.breakingOf(m_bake.breakings[edge.breaking].first + fragment) : nullptr;
    if (pieces) return m_below[static_cast<std::size_t>(pieces - m_bake.breakings.data())][edge.number];
    return {{0.0, lengthOf(edge), edge.breaking, edge.piece, edge.number}};
}

/// Puts together what lies along the edges of the fragment that was broken; its pieces' own lists are there already.
void EdgeStretches::takeStretches(std::uint32_t breaking) {
    const std::vector<PieceEdge> parents = edgesOf(m_bake.breakings[breaking].parent);
    std::vector<std::vector<EdgeStretch>>& lists = m_below[breaking];
    lists.resize(parents.size());
    for (std::uint32_t piece = 0; piece < shapesOf(breaking).pieceCount(); ++piece) {
        for (const PieceEdge& edge : edgesOf(breaking, piece)) {
            if (edge.across != kNone) continue;
            const std::vector<EdgeStretch> stretches = stretchesOf(edge);
            for (const EdgeOverlap& overlap : overlapsOf(edge, parents)) {
                for (EdgeStretch stretch : stretches) {
                    stretch.from = std::max(stretch.from + overlap.start, overlap.from);
                    stretch.to = std::min(stretch.to + overlap.start, overlap.to);
                    if (stretch.to - stretch.from > m_reach) lists[overlap.parent.number].push_back(stretch);
                }
            }
        }
    }
    for (std::vector<EdgeStretch>& list : lists) std::ranges::sort(list, {}, &EdgeStretch::from);
}

}  // namespace rubble
