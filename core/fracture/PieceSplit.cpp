#include "core/fracture/PieceDraft.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace rubble {
namespace {

constexpr double kNearest = 0x1p-40;  // of the piece's reach: a cut keeps farther from corners

/// How far a point lies to the left of a line; its direction has the length 1.
double leftOf(const Line& line, Vec2 point) { return cross(line.direction, point - line.point); }

bool isSmaller(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// A corner in rings that are linked, not listed.
struct LinkedCorner {
    PieceCorner corner;
    std::uint32_t next;
};

std::vector<LinkedCorner> linked(const PieceRings& rings) {
    std::vector<LinkedCorner> corners;
    for (const PieceRing& ring : rings) {
        const auto first = static_cast<std::uint32_t>(corners.size());
        for (const PieceCorner& corner : ring) {
            corners.push_back({corner, static_cast<std::uint32_t>(corners.size()) + 1});
        }
        corners.back().next = first;
    }
    return corners;
}

PieceRings listed(const std::vector<LinkedCorner>& corners) {
    PieceRings rings;
    std::vector<bool> isTaken(corners.size(), false);
    for (std::uint32_t first = 0; first < corners.size(); ++first) {
        if (isTaken[first]) continue;
        PieceRing& ring = rings.emplace_back();
        for (std::uint32_t corner = first; !isTaken[corner]; corner = corners[corner].next) {
            isTaken[corner] = true;
            ring.push_back(corners[corner].corner);
        }
    }
    return rings;
}

Vec2 smallestCorner(const PieceRings& rings, std::span<const Vec2> points) {
    Vec2 smallest = points[rings[0][0].point];
    for (const PieceCorner& corner : rings[0]) {
        if (isSmaller(points[corner.point], smallest)) smallest = points[corner.point];
    }
    return smallest;
}

}  // namespace

Line PieceDraft::clearOfCorners(std::uint32_t piece, Line line) const {
    line.point -= m_partition.origin;
    line.direction = glm::normalize(line.direction);
    double reach = 0.0;
    std::vector<double> distances;
    for (const PieceRing& ring : m_pieces[piece].rings) {
        for (const PieceCorner& corner : ring) {
            distances.push_back(leftOf(line, m_partition.points[corner.point]));
            reach = std::max(reach, glm::length(m_partition.points[corner.point]));
        }
    }
    std::ranges::sort(distances);
    double shift = 0.0;  // to the left: past each corner that it comes too near to
    for (const double distance : distances) {
        if (std::abs(distance - shift) < kNearest * reach) shift = distance + 2.0 * kNearest * reach;
    }
    line.point += shift * Vec2(-line.direction.y, line.direction.x);
    return line;
}

/// Puts a corner where an edge of the piece crosses the line, on both sides of the edge, and gives them in order along the line.
std::vector<std::uint32_t> PieceDraft::addCrossings(std::uint32_t piece, const Line& line) {
    RawVector<Vec2>& points = m_partition.points;
    std::vector<std::uint32_t> crossings;
    PieceRings rings;
    for (const PieceRing& ring : m_pieces[piece].rings) {
        PieceRing& crossed = rings.emplace_back();
        for (std::size_t k = 0; k < ring.size(); ++k) {
            crossed.push_back(ring[k]);
            const std::uint32_t from = ring[k].point, to = ring[k + 1 < ring.size() ? k + 1 : 0].point;
            const double left = leftOf(line, points[from]), right = leftOf(line, points[to]);
            if ((left > 0.0) == (right > 0.0)) continue;
            const auto point = static_cast<std::uint32_t>(points.size());
            points.push_back(points[from] + left / (left - right) * (points[to] - points[from]));
            crossings.push_back(point);
            crossed.push_back({point, ring[k].across});
            if (ring[k].across == kNone) continue;
            const Edge behind = edgeOf(ring[k].across, to, from);
            PieceRing& other = m_pieces[ring[k].across].rings[behind.ring];
            other.insert(other.begin() + static_cast<std::ptrdiff_t>(behind.corner) + 1, {point, piece});
        }
    }
    m_pieces[piece].rings = std::move(rings);
    std::ranges::sort(crossings, {}, [&](std::uint32_t point) {
        return std::pair(glm::dot(line.direction, points[point] - line.point), point);
    });
    return crossings;
}

/// The parts that chords between the first and the second crossing, the third and the fourth, ... leave. What lies behind the
/// chords is said by takeParts().
std::vector<PieceRings> PieceDraft::cutApart(std::uint32_t piece, const std::vector<std::uint32_t>& crossings) {
    std::vector<LinkedCorner> corners = linked(m_pieces[piece].rings);
    std::map<std::uint32_t, std::uint32_t> cornerAt;  // of a crossing
    for (std::uint32_t corner = 0; corner < corners.size(); ++corner) cornerAt[corners[corner].corner.point] = corner;
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
        const std::uint32_t near = cornerAt[crossings[k]], far = cornerAt[crossings[k + 1]];
        const auto nearAgain = static_cast<std::uint32_t>(corners.size()), farAgain = nearAgain + 1;
        corners.push_back(corners[near]);
        corners.push_back(corners[far]);
        corners[near] = {{crossings[k], piece}, farAgain};
        corners[far] = {{crossings[k + 1], piece}, nearAgain};
    }
    std::vector<PieceRings> parts = connectedParts(listed(corners), m_partition.points);
    std::ranges::stable_sort(parts, isSmaller,
                             [&](const PieceRings& rings) { return smallestCorner(rings, m_partition.points); });
    return parts;
}

/// Puts parts in a piece's place, and tells those around who is behind their edges now.
void PieceDraft::takeParts(std::uint32_t piece, std::vector<PieceRings> parts) {
    const std::uint32_t first = count();
    const auto numberOf = [&](std::size_t part) {
        return part == 0 ? piece : first + static_cast<std::uint32_t>(part) - 1;
    };
    std::map<std::array<std::uint32_t, 2>, std::uint32_t> chords;  // those along each: from, to
    for (std::size_t part = 0; part < parts.size(); ++part) {
        for (const PieceRing& ring : parts[part]) {
            for (std::size_t k = 0; k < ring.size(); ++k) {
                const std::uint32_t from = ring[k].point, to = ring[k + 1 < ring.size() ? k + 1 : 0].point;
                if (ring[k].across == piece) chords[{from, to}] = numberOf(part);
                if (ring[k].across == piece || ring[k].across == kNone) continue;
                const Edge behind = edgeOf(ring[k].across, to, from);
                m_pieces[ring[k].across].rings[behind.ring][behind.corner].across = numberOf(part);
            }
        }
    }
    for (PieceRings& rings : parts) {
        for (PieceRing& ring : rings) {
            for (std::size_t k = 0; k < ring.size(); ++k) {
                if (ring[k].across != piece) continue;
                ring[k].across = chords.at({ring[k + 1 < ring.size() ? k + 1 : 0].point, ring[k].point});
            }
        }
    }
    if (m_pieces[piece].part == kNone) m_pieces[piece].part = freePart(piece);
    m_pieces[piece].rings = std::move(parts[0]);
    for (std::size_t part = 1; part < parts.size(); ++part) {
        m_pieces.push_back({std::move(parts[part]), m_pieces[piece].origin, freePart(piece)});
    }
}

std::uint32_t PieceDraft::freePart(std::uint32_t piece) const {
    std::uint32_t free = 0;
    for (std::uint32_t other = 0; other < count(); ++other) {
        if (areNamesakes(other, piece) && m_pieces[other].part != kNone)
            free = std::max(free, m_pieces[other].part + 1);
    }
    return free;
}

std::uint32_t PieceDraft::split(std::uint32_t piece, const Line& line) {
    const Line clear = clearOfCorners(piece, line);
    const std::vector<std::uint32_t> crossings = addCrossings(piece, clear);
    if (crossings.empty()) return 1;
    std::vector<PieceRings> parts = cutApart(piece, crossings);
    const auto count = static_cast<std::uint32_t>(parts.size());
    takeParts(piece, std::move(parts));
    return count;
}

}  // namespace rubble
