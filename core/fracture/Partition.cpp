#include "core/fracture/Partition.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace rubble {

namespace {

/// Calls visit(from, to, across) for every edge of a piece, ring by ring.
template <class Visit>
void forEachEdge(const Partition& partition, std::uint32_t piece, Visit visit) {
    for (std::uint32_t ring = partition.ringsOfPiece[piece]; ring < partition.ringsOfPiece[piece + 1]; ++ring) {
        const std::uint32_t begin = partition.cornersOfRing[ring], end = partition.cornersOfRing[ring + 1];
        for (std::uint32_t corner = begin; corner < end; ++corner) {
            const std::uint32_t next = corner + 1 < end ? corner + 1 : begin;
            visit(partition.corners[corner], partition.corners[next], partition.across[corner]);
        }
    }
}

Ring pointsOf(const Partition& partition, std::uint32_t ring) {
    Ring points;
    points.reserve(partition.ringCorners(ring).size());
    for (const std::uint32_t corner : partition.ringCorners(ring)) points.push_back(partition.points[corner]);
    return points;
}

}  // namespace

Polygon pieceOutline(const Partition& partition, std::uint32_t piece) {
    const std::uint32_t first = partition.ringsOfPiece[piece], end = partition.ringsOfPiece[piece + 1];
    Polygon outline{pointsOf(partition, first), {}};
    for (std::uint32_t ring = first + 1; ring < end; ++ring) outline.holes.push_back(pointsOf(partition, ring));
    return outline;
}

double pieceArea(const Partition& partition, std::uint32_t piece) { return area(pieceOutline(partition, piece)); }

bool hasEdge(const Partition& partition, std::uint32_t piece, std::uint32_t from, std::uint32_t to) {
    bool isFound = false;
    forEachEdge(partition, piece,
                [&](std::uint32_t a, std::uint32_t b, std::uint32_t) { isFound |= a == from && b == to; });
    return isFound;
}

std::vector<Contact> contactsOf(const Partition& partition, std::uint32_t piece, double least) {
    std::map<std::uint32_t, double> lengths;
    forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t across) {
        if (across == kNone) return;
        const Vec2 edge = partition.points[to] - partition.points[from];
        lengths[across] += std::sqrt(edge.x * edge.x + edge.y * edge.y);
    });
    std::vector<Contact> contacts;
    for (const auto& [neighbour, length] : lengths) {
        if (length >= least) contacts.push_back({neighbour, length});
    }
    return contacts;
}

}  // namespace rubble
