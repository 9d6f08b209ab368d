#include "tests/oracle/SubdivisionFault.h"

#include <map>
#include <set>

namespace rubble::oracle {
namespace {

using PointIndex = std::uint32_t;

struct DirectedEdge {
    PointIndex from;
    PointIndex to;
    auto operator<=>(const DirectedEdge&) const = default;
};
struct Sides {
    std::uint32_t piece;
    std::uint32_t neighbour;
};
using Edges = std::map<DirectedEdge, Sides>;

std::string named(const DirectedEdge& edge) {
    return "edge " + std::to_string(edge.from) + "-" + std::to_string(edge.to);
}

/// Ignores unused points.
std::optional<std::string> equalPoints(const Partition& partition) {
    std::map<std::pair<double, double>, PointIndex> seen;
    for (const PointIndex corner : partition.corners) {
        const Vec2 point = partition.points[corner];
        const auto [entry, isNew] = seen.try_emplace({point.x, point.y}, corner);
        if (!isNew && entry->second != corner)
            return "points " + std::to_string(entry->second) + " and " + std::to_string(corner) + " are equal";
    }
    return std::nullopt;
}

std::optional<std::string> collectEdges(const Partition& partition, Edges& edges) {
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
        for (std::uint32_t ring = partition.ringsOfPiece[piece]; ring < partition.ringsOfPiece[piece + 1]; ++ring) {
            const auto corners = partition.ringCorners(ring);
            for (std::size_t k = 0; k < corners.size(); ++k) {
                const DirectedEdge edge{corners[k], corners[(k + 1) % corners.size()]};
                if (edge.from == edge.to) return named(edge) + " has no length";
                const std::uint32_t neighbour = partition.neighbours[partition.cornersOfRing[ring] + k];
                if (!edges.try_emplace(edge, Sides{piece, neighbour}).second) return named(edge) + " occurs twice";
            }
        }
    }
    return std::nullopt;
}

std::optional<std::string> reverseFault(const Edges& edges) {
    for (const auto& [edge, sides] : edges) {
        const auto reverse = edges.find({edge.to, edge.from});
        if (reverse == edges.end()) {
            if (sides.neighbour != kNone) return named(edge) + " has no reverse";
        } else if (reverse->second.piece != sides.neighbour) {
            return named(edge) + " has the wrong neighbour";
        }
    }
    return std::nullopt;
}

/// The boundary enters and leaves each of its points equally often, and contains every outline point.
std::optional<std::string> boundaryFault(const Partition& partition, const Polygon& outline, const Edges& edges) {
    std::map<PointIndex, int> balance;
    for (const auto& [edge, sides] : edges) {
        if (sides.neighbour != kNone) continue;
        ++balance[edge.from];
        --balance[edge.to];
    }
    std::set<std::pair<double, double>> positions;
    for (const auto& [point, balanceAtPoint] : balance) {
        if (balanceAtPoint != 0) return "the boundary ends at point " + std::to_string(point);
        positions.emplace(partition.points[point].x, partition.points[point].y);
    }
    std::vector<Ring> rings = outline.holes;
    rings.push_back(outline.outer);
    for (const Ring& ring : rings) {
        for (const Vec2 corner : ring) {
            const Vec2 local = corner - partition.origin;
            if (!positions.contains({local.x, local.y}))
                return "the outline's point (" + std::to_string(corner.x) + ", " + std::to_string(corner.y) +
                       ") is lost";
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> subdivisionFault(const Partition& partition, const Polygon& outline) {
    if (auto fault = equalPoints(partition)) return fault;
    Edges edges;
    if (auto fault = collectEdges(partition, edges)) return fault;
    if (auto fault = reverseFault(edges)) return fault;
    return boundaryFault(partition, outline, edges);
}

}  // namespace rubble::oracle
