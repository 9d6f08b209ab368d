#include "core/fracture/pieces/PieceSplit.h"

#include "core/geometry/polygon/IndexedCorners.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace rubble {
namespace {

constexpr double kMinClearance = 0x1p-40;  // of the piece's bounding radius: the distance between a cut and corners

/// A corner of rings as linked lists.
struct LinkedCorner {
    PieceCorner corner;
    std::uint32_t next;
};

std::vector<LinkedCorner> linkedCorners(const PieceRings& rings) {
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

PieceRings ringsOf(const std::vector<LinkedCorner>& corners) {
    PieceRings rings;
    std::vector<bool> isVisited(corners.size(), false);
    for (std::uint32_t first = 0; first < corners.size(); ++first) {
        if (isVisited[first]) continue;
        PieceRing& ring = rings.emplace_back();
        for (std::uint32_t corner = first; !isVisited[corner]; corner = corners[corner].next) {
            isVisited[corner] = true;
            ring.push_back(corners[corner].corner);
        }
    }
    return rings;
}

Vec2 smallestCorner(const PieceRings& rings, std::span<const Vec2> points) {
    Vec2 smallest = points[rings[0][0].point];
    for (const PieceCorner& corner : rings[0]) {
        if (lexicographicLess(points[corner.point], smallest)) smallest = points[corner.point];
    }
    return smallest;
}

}  // namespace

double signedDistance(const Line& line, Vec2 point) { return cross(line.direction, point - line.point); }

Line clearOfCorners(const PieceRings& piece, std::span<const Vec2> points, Line line) {
    line.direction = glm::normalize(line.direction);
    double boundingRadius = 0.0;
    std::vector<double> distances;
    for (const PieceRing& ring : piece) {
        for (const PieceCorner& corner : ring) {
            distances.push_back(signedDistance(line, points[corner.point]));
            boundingRadius = std::max(boundingRadius, glm::length(points[corner.point]));
        }
    }
    std::ranges::sort(distances);
    const double clearance = kMinClearance * boundingRadius;
    double shift = 0.0;  // to the left, past each corner that is too close
    for (const double distance : distances) {
        if (std::abs(distance - shift) < clearance) shift = distance + 2.0 * clearance;
    }
    line.point += shift * Vec2(-line.direction.y, line.direction.x);
    return line;
}

std::vector<PieceRings> splitAlongChords(const PieceRings& rings, std::uint32_t piece,
                                         std::span<const std::uint32_t> crossings, std::span<const Vec2> points) {
    std::vector<LinkedCorner> corners = linkedCorners(rings);
    std::map<std::uint32_t, std::uint32_t> cornerAt;  // of a crossing
    for (std::uint32_t corner = 0; corner < corners.size(); ++corner) cornerAt[corners[corner].corner.point] = corner;
    for (std::size_t k = 0; k + 1 < crossings.size(); k += 2) {
        const std::uint32_t near = cornerAt[crossings[k]], far = cornerAt[crossings[k + 1]];
        const auto nearCopy = static_cast<std::uint32_t>(corners.size()), farCopy = nearCopy + 1;
        corners.push_back(corners[near]);
        corners.push_back(corners[far]);
        corners[near] = {{crossings[k], piece}, farCopy};
        corners[far] = {{crossings[k + 1], piece}, nearCopy};
    }
    std::vector<PieceRings> parts = connectedParts(ringsOf(corners), points);
    std::ranges::stable_sort(parts, lexicographicLess,
                             [&](const PieceRings& part) { return smallestCorner(part, points); });
    return parts;
}

}  // namespace rubble
