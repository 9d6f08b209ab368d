#include "core/fracture/verify/VerifyPartition.h"

#include "core/base/DisjointSets.h"
#include "core/base/MessageText.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace rubble {
namespace {

using Fault = std::optional<std::string>;
using PointPair = std::array<std::uint32_t, 2>;

constexpr double kAreaTolerance = 1e-9;   // of the outline's area, or of its diagonal squared
constexpr double kLineTolerance = 1e-12;  // of the outline's diagonal

bool isAscendingTo(std::span<const std::uint32_t> offsets, std::size_t entries, std::size_t last) {
    return offsets.size() == entries + 1 && offsets.front() == 0 && offsets.back() == last &&
           std::is_sorted(offsets.begin(), offsets.end());
}

Fault verifyArrays(const Partition& p) {
    if (!isAscendingTo(p.cornersOfRing, p.cornersOfRing.size() - 1, p.corners.size()) ||
        !isAscendingTo(p.ringsOfPiece, p.seedOfPiece.size(), p.cornersOfRing.size() - 1) ||
        p.neighbours.size() != p.corners.size()) {
        return "The sizes of the partition's arrays do not match.";
    }
    for (std::uint32_t piece = 0; piece < p.pieceCount(); ++piece) {
        if (p.isEmpty(piece)) return "Piece " + std::to_string(piece) + " has no ring.";
        const std::uint32_t seed = p.seedOfPiece[piece];
        if (seed != kNone && (seed >= p.pieceOfSeed.size() || p.pieceOfSeed[seed] > piece)) {
            return "Seed " + std::to_string(seed) + " does not refer to its piece " + std::to_string(piece) + ".";
        }
    }
    for (std::size_t corner = 0; corner < p.corners.size(); ++corner) {
        if (p.corners[corner] >= p.points.size())
            return "Corner " + std::to_string(corner) + " refers to a point that does not exist.";
        const Vec2 point = p.points[p.corners[corner]];
        if (!std::isfinite(point.x) || !std::isfinite(point.y))
            return "Corner " + std::to_string(corner) + " is not finite.";
    }
    return std::nullopt;
}

Ring pointsOfRing(const Partition& partition, std::uint32_t ring) {
    Ring points;
    for (const std::uint32_t corner : partition.ringCorners(ring)) points.push_back(partition.points[corner]);
    return points;
}

/// The piece of each directed edge, and the edges on the outline.
struct Edges {
    std::map<PointPair, std::uint32_t> pieces;
    std::map<std::uint32_t, std::uint32_t> outlineNext;  // from each point to the next along the outline
};

/// A directed edge of a piece, and the piece behind it.
struct PieceEdge {
    std::uint32_t piece, from, to, neighbour;

    std::string text() const { return "edge from point " + std::to_string(from) + " to " + std::to_string(to); }
};

/// The first fault that check(edge) finds, piece by piece.
template <class Check>
Fault firstFaultOfEdges(const Partition& p, Check check) {
    Fault fault;
    for (std::uint32_t piece = 0; piece < p.pieceCount() && !fault; ++piece) {
        forEachEdge(p, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
            if (!fault) fault = check(PieceEdge{piece, from, to, neighbour});
        });
    }
    return fault;
}

Fault collectEdges(const Partition& p, Edges& edges) {
    return firstFaultOfEdges(p, [&](const PieceEdge& edge) -> Fault {
        const auto& [piece, from, to, neighbour] = edge;
        const bool isNew = from != to && edges.pieces.emplace(PointPair{from, to}, piece).second;
        if (!isNew) return "Piece " + std::to_string(piece) + " repeats the " + edge.text() + ".";
        if (neighbour == kNone && !edges.outlineNext.emplace(from, to).second)
            return "Two edges along the outline start at point " + std::to_string(from) + ".";
        return std::nullopt;
    });
}

Fault verifyNeighbours(const Partition& p, const Edges& edges) {
    return firstFaultOfEdges(p, [&](const PieceEdge& edge) -> Fault {
        const auto reverse = edges.pieces.find({edge.to, edge.from});
        const std::uint32_t behind = reverse == edges.pieces.end() ? kNone : reverse->second;
        if (behind == edge.neighbour && behind != edge.piece) return std::nullopt;
        return "Piece " + std::to_string(edge.piece) + " does not have the right neighbour behind its " + edge.text() +
               ".";
    });
}

/// No ring touches itself.
Fault verifyRingsAreSimple(const Partition& p) {
    for (std::uint32_t ring = 0; ring + 1 < p.cornersOfRing.size(); ++ring) {
        const std::span<const std::uint32_t> corners = p.ringCorners(ring);
        std::vector<std::uint32_t> sorted(corners.begin(), corners.end());
        std::sort(sorted.begin(), sorted.end());
        if (const auto twice = std::adjacent_find(sorted.begin(), sorted.end()); twice != sorted.end()) {
            return "Ring " + std::to_string(ring) + " touches itself at point " + std::to_string(*twice) + ".";
        }
    }
    return std::nullopt;
}

/// The graph of rings that touch at points is a forest: a cycle would disconnect the piece.
Fault verifyPiecesAreConnected(const Partition& p) {
    DisjointSets connectedRings(p.cornersOfRing.size());
    for (std::uint32_t piece = 0; piece < p.pieceCount(); ++piece) {
        if (p.ringCount(piece) < 2) continue;
        std::map<std::uint32_t, std::uint32_t> ringAt;  // the first at each point
        for (std::uint32_t ring = p.ringsOfPiece[piece]; ring < p.ringsOfPiece[piece + 1]; ++ring) {
            for (const std::uint32_t point : p.ringCorners(ring)) {
                const auto [entry, isNew] = ringAt.try_emplace(point, ring);
                if (isNew) continue;
                if (!connectedRings.merge(entry->second, ring))
                    return "Piece " + std::to_string(piece) + " is disconnected by points, one of them is " +
                           std::to_string(point) + ".";
            }
        }
    }
    return std::nullopt;
}

/// The edges without a neighbour run along the outline, through all of its points.
Fault verifyOutlineIsKept(const Partition& p, const Edges& edges, const Polygon& outline, double tolerance) {
    std::map<std::array<double, 2>, std::uint32_t> pointAt;
    for (const auto& [from, to] : edges.outlineNext)
        pointAt.emplace(std::array{p.points[from].x, p.points[from].y}, from);
    std::size_t used = 0;
    const auto follow = [&](const Ring& ring, const std::string& name) -> Fault {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Vec2 start = ring[i] - p.origin, end = ring[i + 1 < ring.size() ? i + 1 : 0] - p.origin;
            const auto found = pointAt.find({start.x, start.y});
            if (found == pointAt.end())
                return "Point " + std::to_string(i) + " of " + name + " is not a corner of any piece.";
            const Vec2 direction = end - start;
            const double length = std::sqrt(direction.x * direction.x + direction.y * direction.y);
            std::uint32_t point = found->second;
            do {
                const auto next = edges.outlineNext.find(point);
                if (next == edges.outlineNext.end() || ++used > edges.outlineNext.size())
                    return "The pieces leave " + name + " after point " + std::to_string(i) + ".";
                const Vec2 step = p.points[next->second] - p.points[point];
                const Vec2 offset = p.points[next->second] - start;
                if (step.x * direction.x + step.y * direction.y <= 0.0 ||
                    std::abs(cross(direction, offset)) > tolerance * length) {
                    return "The pieces leave " + name + " after point " + std::to_string(i) + ".";
                }
                point = next->second;
            } while (p.points[point] != end);
        }
        return std::nullopt;
    };
    if (Fault fault = follow(outline.outer, "the outline")) return fault;
    for (std::size_t hole = 0; hole < outline.holes.size(); ++hole) {
        if (Fault fault = follow(outline.holes[hole], "hole " + std::to_string(hole))) return fault;
    }
    if (used != edges.outlineNext.size()) return "Some edges inside the outline have no neighbour.";
    return std::nullopt;
}

Fault verifyAreas(const Partition& p, const Polygon& outline, double diagonal) {
    const double slack = 1e-3 * kAreaTolerance * diagonal * diagonal;
    double sum = 0.0;
    for (std::uint32_t piece = 0; piece < p.pieceCount(); ++piece) {
        for (std::uint32_t ring = p.ringsOfPiece[piece]; ring < p.ringsOfPiece[piece + 1]; ++ring) {
            const double ringArea = signedArea(pointsOfRing(p, ring));
            const bool isOuter = ring == p.ringsOfPiece[piece];
            if (p.cornersOfRing[ring + 1] - p.cornersOfRing[ring] < 3 ||
                (isOuter ? ringArea < -slack : ringArea > slack)) {
                return "Ring " + std::to_string(ring - p.ringsOfPiece[piece]) + " of piece " + std::to_string(piece) +
                       " has the wrong winding or no area.";
            }
            sum += ringArea;
        }
    }
    const double expected = area(outline) - p.gap;
    if (std::abs(sum - expected) > kAreaTolerance * area(outline)) {
        return "The pieces' areas sum to " + messageText(sum) + " m² instead of " + messageText(expected) + " m².";
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> verifyPartition(const Partition& partition, const Polygon& outline) {
    const double diagonal = boundsOf(outline.outer).diagonal();
    if (Fault fault = verifyArrays(partition)) return fault;
    Edges edges;
    if (Fault fault = collectEdges(partition, edges)) return fault;
    if (Fault fault = verifyNeighbours(partition, edges)) return fault;
    if (Fault fault = verifyRingsAreSimple(partition)) return fault;
    if (Fault fault = verifyPiecesAreConnected(partition)) return fault;
    if (Fault fault = verifyOutlineIsKept(partition, edges, outline, kLineTolerance * diagonal)) return fault;
    return verifyAreas(partition, outline, diagonal);
}

}  // namespace rubble
