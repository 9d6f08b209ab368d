#include "core/fracture/pieces/PieceDraft.h"

#include "core/base/Assert.h"
#include "core/fracture/pattern/PatternPartition.h"
#include "core/fracture/pieces/PieceMerge.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <map>

namespace rubble {
namespace {

/// The edge from one point to another, which the piece has.
RingEdge edgeOf(const PieceRings& rings, std::uint32_t from, std::uint32_t to) {
    const std::optional<RingEdge> edge = findEdge(rings, {from, to});
    RUBBLE_ASSERT(edge);
    return *edge;
}

void append(const PieceRings& rings, std::span<const std::uint32_t> numbers, Partition& partition) {
    for (const PieceRing& ring : rings) {
        for (const PieceCorner& corner : ring) {
            partition.corners.push_back(corner.point);
            partition.neighbours.push_back(corner.neighbour == kNone ? kNone : numbers[corner.neighbour]);
        }
        partition.cornersOfRing.push_back(static_cast<std::uint32_t>(partition.corners.size()));
    }
    partition.ringsOfPiece.push_back(static_cast<std::uint32_t>(partition.cornersOfRing.size() - 1));
}

}  // namespace

PieceDraft::PieceDraft(Partition partition) : m_partition(std::move(partition)) {
    const Partition& p = m_partition;
    m_rings.resize(p.pieceCount());
    for (std::uint32_t piece = 0; piece < p.pieceCount(); ++piece) {
        m_names.push_back({piece, partOfCell(p, piece)});
        for (std::uint32_t ring = p.ringsOfPiece[piece]; ring < p.ringsOfPiece[piece + 1]; ++ring) {
            PieceRing& corners = m_rings[piece].emplace_back();
            for (std::uint32_t corner = p.cornersOfRing[ring]; corner < p.cornersOfRing[ring + 1]; ++corner) {
                corners.push_back({p.corners[corner], p.neighbours[corner]});
            }
        }
    }
}

std::string PieceDraft::nameOf(std::uint32_t piece, std::span<const SeedId> seeds) const {
    const std::string cell = cellName(m_partition, m_names[piece].source, seeds);
    const std::uint32_t part = m_names[piece].part;
    return part == kNone ? cell : cell + "." + std::to_string(part);
}

bool PieceDraft::areInSameCell(std::uint32_t piece, std::uint32_t other) const {
    return seedOf(piece) == seedOf(other) && std::ranges::equal(cutCellsOf(piece), cutCellsOf(other));
}

bool PieceDraft::areNeighbours(std::uint32_t piece, std::uint32_t other) const {
    return std::ranges::any_of(m_rings[piece], [&](const PieceRing& ring) {
        return std::ranges::find(ring, other, &PieceCorner::neighbour) != ring.end();
    });
}

void PieceDraft::merge(std::span<const std::uint32_t> receivers) {
    std::vector<std::vector<std::uint32_t>> groups(count());  // those with more than one member, by receiver
    for (std::uint32_t piece = 0; piece < count(); ++piece) {
        if (receivers[piece] == piece || !exists(piece)) continue;
        std::vector<std::uint32_t>& group = groups[receivers[piece]];
        if (group.empty()) group.push_back(receivers[piece]);
        group.push_back(piece);
    }
    std::vector<PieceRings> merged(count());
    for (std::uint32_t receiver = 0; receiver < count(); ++receiver) {
        if (groups[receiver].empty()) continue;
        std::ranges::sort(groups[receiver]);
        merged[receiver] = mergedRings(m_rings, groups[receiver], receivers, m_partition.points);
    }
    for (std::uint32_t receiver = 0; receiver < count(); ++receiver) {
        for (const std::uint32_t member : groups[receiver]) m_rings[member].clear();
        if (!groups[receiver].empty()) m_rings[receiver] = std::move(merged[receiver]);
    }
    for (PieceRings& rings : m_rings) {
        for (PieceRing& ring : rings) {
            for (PieceCorner& corner : ring) {
                if (corner.neighbour != kNone) corner.neighbour = receivers[corner.neighbour];
            }
        }
    }
}

/// Inserts a corner where an edge of the piece crosses the line, in both pieces of the edge. Returns the points in
/// order along the line.
std::vector<std::uint32_t> PieceDraft::addCrossings(std::uint32_t piece, const Line& line) {
    UninitializedVector<Vec2>& points = m_partition.points;
    std::vector<std::uint32_t> crossings;
    PieceRings rings;
    for (const PieceRing& ring : m_rings[piece]) {
        PieceRing& crossed = rings.emplace_back();
        for (std::size_t k = 0; k < ring.size(); ++k) {
            crossed.push_back(ring[k]);
            const std::uint32_t from = ring[k].point, to = ring[nextCorner(ring, k)].point;
            const double start = signedDistance(line, points[from]), end = signedDistance(line, points[to]);
            if ((start > 0.0) == (end > 0.0)) continue;
            const auto point = static_cast<std::uint32_t>(points.size());
            points.push_back(points[from] + start / (start - end) * (points[to] - points[from]));
            crossings.push_back(point);
            crossed.push_back({point, ring[k].neighbour});
            if (ring[k].neighbour == kNone) continue;
            const RingEdge behind = edgeOf(m_rings[ring[k].neighbour], to, from);
            PieceRing& other = m_rings[ring[k].neighbour][behind.ring];
            other.insert(other.begin() + static_cast<std::ptrdiff_t>(behind.corner) + 1, {point, piece});
        }
    }
    m_rings[piece] = std::move(rings);
    std::ranges::sort(crossings, {}, [&](std::uint32_t point) {
        return std::pair(glm::dot(line.direction, points[point] - line.point), point);
    });
    return crossings;
}

/// Replaces a piece by its parts, and updates the neighbours of the edges around them and between them.
void PieceDraft::replaceByParts(std::uint32_t piece, std::vector<PieceRings> parts) {
    const std::uint32_t first = count();
    const auto numberOf = [&](std::size_t part) {
        return part == 0 ? piece : first + static_cast<std::uint32_t>(part) - 1;
    };
    std::map<std::array<std::uint32_t, 2>, std::uint32_t> partAtChord;  // by an edge {from, to}
    for (std::size_t part = 0; part < parts.size(); ++part) {
        for (const PieceRing& ring : parts[part]) {
            for (std::size_t k = 0; k < ring.size(); ++k) {
                const std::uint32_t from = ring[k].point, to = ring[nextCorner(ring, k)].point;
                if (ring[k].neighbour == piece) partAtChord[{from, to}] = numberOf(part);
                if (ring[k].neighbour == piece || ring[k].neighbour == kNone) continue;
                const RingEdge behind = edgeOf(m_rings[ring[k].neighbour], to, from);
                m_rings[ring[k].neighbour][behind.ring][behind.corner].neighbour = numberOf(part);
            }
        }
    }
    for (PieceRings& rings : parts) {
        for (PieceRing& ring : rings) {
            for (std::size_t k = 0; k < ring.size(); ++k) {
                if (ring[k].neighbour != piece) continue;
                ring[k].neighbour = partAtChord.at({ring[nextCorner(ring, k)].point, ring[k].point});
            }
        }
    }
    if (m_names[piece].part == kNone) m_names[piece].part = freePart(piece);
    m_rings[piece] = std::move(parts[0]);
    for (std::size_t part = 1; part < parts.size(); ++part) {
        const std::uint32_t number = freePart(piece);
        m_rings.push_back(std::move(parts[part]));
        m_names.push_back({m_names[piece].source, number});
    }
}

/// The lowest part number above those of all pieces in the same cell.
std::uint32_t PieceDraft::freePart(std::uint32_t piece) const {
    std::uint32_t free = 0;
    for (std::uint32_t other = 0; other < count(); ++other) {
        if (areInSameCell(other, piece) && m_names[other].part != kNone) free = std::max(free, m_names[other].part + 1);
    }
    return free;
}

std::uint32_t PieceDraft::split(std::uint32_t piece, const Line& line) {
    const Line clear =
        clearOfCorners(m_rings[piece], m_partition.points, {line.point - m_partition.origin, line.direction});
    const std::vector<std::uint32_t> crossings = addCrossings(piece, clear);
    if (crossings.empty()) return 1;
    std::vector<PieceRings> parts = splitAlongChords(m_rings[piece], piece, crossings, m_partition.points);
    const auto count = static_cast<std::uint32_t>(parts.size());
    replaceByParts(piece, std::move(parts));
    return count;
}

/// The existing pieces in the order of the finished partition.
std::vector<std::uint32_t> PieceDraft::finalOrder() const {
    std::vector<std::uint32_t> firstOfSeed(m_partition.pieceOfSeed.size() + 1, kNone);  // the last: of no seed
    const auto firstPiece = [&](std::uint32_t piece) -> std::uint32_t& {
        const std::uint32_t seed = seedOf(piece);
        return firstOfSeed[seed == kNone ? firstOfSeed.size() - 1 : seed];
    };
    std::vector<std::uint32_t> order;
    for (std::uint32_t piece = 0; piece < count(); ++piece) {
        if (!exists(piece)) continue;
        order.push_back(piece);
        if (firstPiece(piece) == kNone) firstPiece(piece) = piece;
    }
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        if (firstPiece(a) != firstPiece(b)) return firstPiece(a) < firstPiece(b);
        if (!areInSameCell(a, b)) return std::ranges::lexicographical_compare(cutCellsOf(a), cutCellsOf(b));
        return std::pair(m_names[a].part, a) < std::pair(m_names[b].part, b);
    });
    return order;
}

Partition PieceDraft::finished() && {
    const std::vector<std::uint32_t> order = finalOrder();
    std::vector<std::uint32_t> numbers(count(), kNone);
    for (std::uint32_t k = 0; k < order.size(); ++k) numbers[order[k]] = k;

    Partition result{.origin = m_partition.origin, .points = std::move(m_partition.points)};
    result.gap = m_partition.gap;
    result.diagnostics = std::move(m_partition.diagnostics);
    result.cutLayers = m_partition.cutLayers;
    result.pieceOfSeed.assign(m_partition.pieceOfSeed.size(), kNone);
    result.ringsOfPiece = {0};
    result.cornersOfRing = {0};
    for (const std::uint32_t piece : order) {
        const std::uint32_t seed = seedOf(piece);
        if (seed != kNone && result.pieceOfSeed[seed] == kNone) result.pieceOfSeed[seed] = numbers[piece];
        result.seedOfPiece.push_back(seed);
        result.partOfCell.push_back(m_names[piece].part);
        for (const std::uint32_t cell : cutCellsOf(piece)) result.cutCells.push_back(cell);
        append(m_rings[piece], numbers, result);
    }
    return result;
}

}  // namespace rubble
