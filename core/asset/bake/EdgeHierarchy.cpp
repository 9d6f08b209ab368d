#include "core/asset/bake/EdgeHierarchy.h"

#include "core/base/Assert.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace rubble {
namespace {

/// The overlap of the segment from `a` to `b` with an edge that begins at (0, 0): where it is within `tolerance` of it.
std::optional<EdgeOverlap> overlapOf(Vec2 a, Vec2 b, Vec2 edge, double tolerance) {
    const double length = glm::length(edge);
    if (!(length > 0.0)) return std::nullopt;
    const Vec2 along = edge / length, left = perpendicular(along);
    const double start = glm::dot(a, along), end = glm::dot(b, along);
    const double from = std::max(start, 0.0), to = std::min(end, length);
    if (!(to - from > tolerance)) return std::nullopt;
    const double distance = glm::dot(a, left), slope = glm::dot(b - a, left) / (end - start);
    const auto isOnEdge = [&](double at) { return std::abs(distance + (at - start) * slope) <= tolerance; };
    if (!isOnEdge(from) || !isOnEdge(to)) return std::nullopt;
    return EdgeOverlap{{}, start, from, to};
}

}  // namespace

EdgeHierarchy::EdgeHierarchy(const Bake& bake, double tolerance)
    : m_bake(bake), m_tolerance(tolerance), m_parents(bake.fractures.size()), m_intervals(bake.fractures.size()) {
    for (std::size_t k = bake.fractures.size(); k-- > 1;) {
        m_parents[k] = indexedEdgesOf(bake.fractures[k].parent);
        addIntervals(static_cast<std::uint32_t>(k));
    }
}

Vec2 EdgeHierarchy::originOf(std::uint32_t fracture) const {
    return shapesOf(fracture).origin + Vec2{fragmentsOf(fracture).origin};
}

double EdgeHierarchy::lengthOf(const PieceEdge& edge) const {
    const Partition& shapes = shapesOf(edge.fracture);
    return glm::distance(shapes.points[edge.from], shapes.points[edge.to]);
}

std::vector<PieceEdge> EdgeHierarchy::edgesOf(FracturePiece piece) const {
    std::vector<PieceEdge> edges;
    forEachEdge(shapesOf(piece.fracture), piece.piece,
                [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
                    const auto number = static_cast<std::uint32_t>(edges.size());
                    edges.push_back({piece.fracture, piece.piece, number, from, to, neighbour});
                });
    return edges;
}

std::vector<PieceEdge> EdgeHierarchy::edgesOf(std::uint32_t fragment) const {
    const std::uint32_t fracture = m_bake.fractureContaining(fragment);
    return edgesOf(
        {fracture, fragmentsOf(fracture).extruded()->pieceOfFragment[fragment - m_bake.fractures[fracture].first]});
}

EdgeHierarchy::FragmentEdges EdgeHierarchy::indexedEdgesOf(std::uint32_t fragment) const {
    std::vector<PieceEdge> edges = edgesOf(fragment);
    std::vector<Box3> boxes;
    for (const PieceEdge& edge : edges) {
        const UninitializedVector<Vec2>& points = shapesOf(edge.fracture).points;
        boxes.push_back(boxOf(points[edge.from], points[edge.to]));
    }
    return {std::move(edges), BoxTree(boxes)};
}

std::vector<EdgeOverlap> EdgeHierarchy::overlapsOf(const PieceEdge& edge) const {
    std::vector<EdgeOverlap> overlaps;
    const std::optional<FragmentEdges>& parents = m_parents[edge.fracture];
    if (!parents) return overlaps;
    RUBBLE_ASSERT(!parents->edges.empty());  // only fragments have edges here, never pieces that vanished
    const std::uint32_t above = parents->edges.front().fracture;
    const UninitializedVector<Vec2>&points = shapesOf(edge.fracture).points, &pointsAbove = shapesOf(above).points;
    const Vec2 shift = originOf(edge.fracture) - originOf(above);
    const Vec2 from = points[edge.from] + shift, to = points[edge.to] + shift;
    Box3 around = boxOf(from, to);
    const Vec3 margin(2.0 * m_tolerance, 2.0 * m_tolerance, 0.0);  // twice: overlapOf() decides
    around.min -= margin;
    around.max += margin;
    std::vector<std::uint32_t> near;
    parents->tree.visitOverlapping(around, [&](std::uint32_t k) { near.push_back(k); });
    std::ranges::sort(near);
    for (const std::uint32_t k : near) {
        const PieceEdge& parent = parents->edges[k];
        const Vec2 begin = pointsAbove[parent.from];
        std::optional<EdgeOverlap> overlap =
            overlapOf(from - begin, to - begin, pointsAbove[parent.to] - begin, m_tolerance);
        if (!overlap) continue;
        overlap->parent = parent;
        overlaps.push_back(*overlap);
    }
    const auto begin = [](const EdgeOverlap& overlap) { return overlap.from - overlap.start; };
    std::ranges::sort(overlaps, {}, begin);
    return overlaps;
}

std::vector<EdgeInterval> EdgeHierarchy::intervalsOf(const PieceEdge& edge) const {
    const Fragments& fragments = fragmentsOf(edge.fracture);
    const std::uint32_t fragment = fragments.extruded()->fragmentOfPiece[edge.piece];
    const bool isFragment = fragment != kNone && fragments.extruded()->pieceOfFragment[fragment] == edge.piece;
    const BakedFracture* pieces =
        isFragment ? m_bake.fractureOf(m_bake.fractures[edge.fracture].first + fragment) : nullptr;
    if (pieces) return m_intervals[static_cast<std::size_t>(pieces - m_bake.fractures.data())][edge.number];
    return {{0.0, lengthOf(edge), edge.fracture, edge.piece, edge.number}};
}

/// Collects the intervals along the edges of a fracture's parent. Those of its pieces must be known.
void EdgeHierarchy::addIntervals(std::uint32_t fracture) {
    std::vector<std::vector<EdgeInterval>>& lists = m_intervals[fracture];
    lists.resize(m_parents[fracture]->edges.size());
    for (std::uint32_t piece = 0; piece < shapesOf(fracture).pieceCount(); ++piece) {
        for (const PieceEdge& edge : edgesOf({fracture, piece})) {
            if (edge.neighbour != kNone) continue;
            const std::vector<EdgeInterval> intervals = intervalsOf(edge);
            for (const EdgeOverlap& overlap : overlapsOf(edge)) {
                for (EdgeInterval interval : intervals) {
                    interval.from = std::max(interval.from + overlap.start, overlap.from);
                    interval.to = std::min(interval.to + overlap.start, overlap.to);
                    if (interval.to - interval.from > m_tolerance) lists[overlap.parent.number].push_back(interval);
                }
            }
        }
    }
    for (std::vector<EdgeInterval>& list : lists) std::ranges::sort(list, {}, &EdgeInterval::from);
}

}  // namespace rubble
