#include "core/fracture/Partition.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace rubble {

namespace {

Ring pointsOf(const Partition& partition, std::uint32_t ring, Vec2 centre) {
    Ring points;
    points.reserve(partition.ringCorners(ring).size());
    for (const std::uint32_t corner : partition.ringCorners(ring)) points.push_back(partition.points[corner] - centre);
    return points;
}

bool areNamesakes(const Partition& partition, std::uint32_t one, std::uint32_t other) {
    return partition.seedOfPiece[one] == partition.seedOfPiece[other] &&
           std::ranges::equal(partition.cutCellsOf(one), partition.cutCellsOf(other));
}

}  // namespace

std::uint32_t partOfCell(const Partition& partition, std::uint32_t piece) {
    if (!partition.partOfCell.empty()) return partition.partOfCell[piece];
    std::uint32_t first = piece, end = piece + 1;
    while (first > 0 && areNamesakes(partition, first - 1, piece)) --first;
    while (end < partition.pieceCount() && areNamesakes(partition, end, piece)) ++end;
    return end - first > 1 ? piece - first : kNone;
}

Polygon pieceOutline(const Partition& partition, std::uint32_t piece, Vec2 centre) {
    const std::uint32_t first = partition.ringsOfPiece[piece], end = partition.ringsOfPiece[piece + 1];
    Polygon outline{pointsOf(partition, first, centre), {}};
    for (std::uint32_t ring = first + 1; ring < end; ++ring) outline.holes.push_back(pointsOf(partition, ring, centre));
    return outline;
}

double pieceArea(const Partition& partition, std::uint32_t piece) { return area(pieceOutline(partition, piece)); }

bool hasEdge(const Partition& partition, std::uint32_t piece, std::uint32_t from, std::uint32_t to) {
    bool isFound = false;
    forEachEdge(partition, piece,
                [&](std::uint32_t a, std::uint32_t b, std::uint32_t) { isFound |= a == from && b == to; });
    return isFound;
}

std::vector<PieceContact> contactsOf(const Partition& partition, std::uint32_t piece, double least) {
    std::map<std::uint32_t, double> lengths;
    forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t across) {
        if (across == kNone) return;
        const Vec2 edge = partition.points[to] - partition.points[from];
        lengths[across] += std::sqrt(edge.x * edge.x + edge.y * edge.y);
    });
    std::vector<PieceContact> contacts;
    for (const auto& [neighbour, length] : lengths) {
        if (length >= least) contacts.push_back({neighbour, length});
    }
    return contacts;
}

}  // namespace rubble
