#include "core/fracture/partition/Partition.h"

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

bool haveSameName(const Partition& partition, std::uint32_t one, std::uint32_t other) {
    return partition.seedOfPiece[one] == partition.seedOfPiece[other] &&
           std::ranges::equal(partition.cutCellsOf(one), partition.cutCellsOf(other));
}

}  // namespace

std::uint32_t partOfCell(const Partition& partition, std::uint32_t piece) {
    if (!partition.partOfCell.empty()) return partition.partOfCell[piece];
    // The pieces of one name are consecutive: exponential search for their ends, as a cell may have very many.
    const auto extent = [&](std::uint32_t limit, auto at) {
        std::uint32_t step = 1, count = 0;  // of pieces with the name, beyond the piece itself
        while (count + step <= limit && haveSameName(partition, at(count + step), piece)) count += step, step *= 2;
        for (; step > 0; step /= 2) {
            if (count + step <= limit && haveSameName(partition, at(count + step), piece)) count += step;
        }
        return count;
    };
    const std::uint32_t before = extent(piece, [&](std::uint32_t k) { return piece - k; });
    const std::uint32_t after = extent(partition.pieceCount() - 1 - piece, [&](std::uint32_t k) { return piece + k; });
    return before + after > 0 ? before : kNone;
}

bool areSamePieces(const Partition& a, const Partition& b) {
    return a.points == b.points && a.ringsOfPiece == b.ringsOfPiece && a.cornersOfRing == b.cornersOfRing &&
           a.corners == b.corners;
}

Polygon pieceOutline(const Partition& partition, std::uint32_t piece, Vec2 centre) {
    if (partition.isEmpty(piece)) return {};
    const std::uint32_t outer = partition.outerRing(piece), end = outer + partition.ringCount(piece);
    Polygon outline{pointsOf(partition, outer, centre), {}};
    for (std::uint32_t ring = outer + 1; ring < end; ++ring) outline.holes.push_back(pointsOf(partition, ring, centre));
    return outline;
}

double pieceArea(const Partition& partition, std::uint32_t piece) { return area(pieceOutline(partition, piece)); }

std::vector<double> pieceAreas(const Partition& partition) {
    std::vector<double> areas(partition.pieceCount());
    for (std::uint32_t piece = 0; piece < areas.size(); ++piece) areas[piece] = pieceArea(partition, piece);
    return areas;
}

std::string cellText(const Partition& partition, std::uint32_t piece) {
    const std::uint32_t seed = partition.seedOfPiece[piece];
    return seed == kNone ? "the outline" : "the cell of seed " + std::to_string(seed);
}

bool hasEdge(const Partition& partition, std::uint32_t piece, PointEdge edge) {
    bool isFound = false;
    forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t) {
        isFound |= from == edge.from && to == edge.to;
    });
    return isFound;
}

std::vector<PieceContact> contactsOf(const Partition& partition, std::uint32_t piece, double minLength) {
    std::map<std::uint32_t, double> lengths;
    forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
        if (neighbour == kNone) return;
        const Vec2 edge = partition.points[to] - partition.points[from];
        lengths[neighbour] += std::sqrt(edge.x * edge.x + edge.y * edge.y);
    });
    std::vector<PieceContact> contacts;
    for (const auto& [neighbour, length] : lengths) {
        if (length >= minLength) contacts.push_back({neighbour, length});
    }
    return contacts;
}

}  // namespace rubble
