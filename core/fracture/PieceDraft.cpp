#include "core/fracture/PieceDraft.h"

#include "core/base/Assert.h"
#include "core/fracture/PatternPartition.h"

#include <algorithm>
#include <numeric>

namespace rubble {
namespace {

std::size_t after(std::size_t corner, const PieceRing& ring) { return corner + 1 < ring.size() ? corner + 1 : 0; }

double ringArea(const PieceRing& ring, std::span<const Vec2> points) {
    Ring places;
    for (const PieceCorner& corner : ring) places.push_back(points[corner.point]);
    return signedArea(places);
}

/// The rings of an area that hangs together, the outer one first. Where rounding makes a hole without width look like an area,
/// it is a hole all the same.
PieceRings onePiece(PieceRings boundary, std::span<const Vec2> points) {
    std::vector<PieceRings> parts = connectedParts(std::move(boundary), points);
    const auto largest =
        std::ranges::max_element(parts, {}, [&](const PieceRings& rings) { return ringArea(rings[0], points); });
    std::iter_swap(parts.begin(), largest);
    PieceRings& rings = parts[0];
    for (std::size_t k = 1; k < parts.size(); ++k) rings.insert(rings.end(), parts[k].begin(), parts[k].end());
    return std::move(rings);
}

void append(const PieceRings& rings, std::span<const std::uint32_t> numbers, Partition& partition) {
    for (const PieceRing& ring : rings) {
        for (const PieceCorner& corner : ring) {
            partition.corners.push_back(corner.point);
            partition.across.push_back(corner.across == kNone ? kNone : numbers[corner.across]);
        }
        partition.cornersOfRing.push_back(static_cast<std::uint32_t>(partition.corners.size()));
    }
    partition.ringsOfPiece.push_back(static_cast<std::uint32_t>(partition.cornersOfRing.size() - 1));
}

}  // namespace

PieceDraft::PieceDraft(Partition partition) : m_partition(std::move(partition)) {
    const Partition& p = m_partition;
    m_pieces.resize(p.pieceCount());
    for (std::uint32_t piece = 0; piece < p.pieceCount(); ++piece) {
        m_pieces[piece] = {{}, piece, partOfCell(p, piece)};
        for (std::uint32_t ring = p.ringsOfPiece[piece]; ring < p.ringsOfPiece[piece + 1]; ++ring) {
            PieceRing& corners = m_pieces[piece].rings.emplace_back();
            for (std::uint32_t corner = p.cornersOfRing[ring]; corner < p.cornersOfRing[ring + 1]; ++corner) {
                corners.push_back({p.corners[corner], p.across[corner]});
            }
        }
    }
}

std::string PieceDraft::nameOf(std::uint32_t piece, std::span<const SeedId> seeds) const {
    const std::string cell = cellName(m_partition, m_pieces[piece].origin, seeds);
    const std::uint32_t part = m_pieces[piece].part;
    return part == kNone ? cell : cell + "." + std::to_string(part);
}

bool PieceDraft::areNamesakes(std::uint32_t piece, std::uint32_t other) const {
    return seedOf(piece) == seedOf(other) && std::ranges::equal(cutCellsOf(piece), cutCellsOf(other));
}

bool PieceDraft::areNeighbours(std::uint32_t piece, std::uint32_t other) const {
    return std::ranges::any_of(m_pieces[piece].rings, [&](const PieceRing& ring) {
        return std::ranges::find(ring, other, &PieceCorner::across) != ring.end();
    });
}

PieceDraft::Edge PieceDraft::edgeOf(std::uint32_t piece, std::uint32_t from, std::uint32_t to) const {
    const PieceRings& rings = m_pieces[piece].rings;
    for (std::size_t ring = 0; ring < rings.size(); ++ring) {
        for (std::size_t corner = 0; corner < rings[ring].size(); ++corner) {
            if (rings[ring][corner].point == from && rings[ring][after(corner, rings[ring])].point == to) {
                return {ring, corner};
            }
        }
    }
    RUBBLE_ASSERT(false);
    return {};
}

/// The edges of a group that have something else behind them. At the end of each the way goes on around the point, through
/// the edges within the group, to the next of them.
PieceRings PieceDraft::boundaryOf(const std::vector<std::uint32_t>& group,
                                  std::span<const std::uint32_t> receivers) const {
    struct Place {
        std::uint32_t piece;
        Edge edge;
    };
    const auto cornerAt = [&](const Place& place) -> const PieceCorner& {
        return m_pieces[place.piece].rings[place.edge.ring][place.edge.corner];
    };
    const auto isWithin = [&](const Place& place) {
        const std::uint32_t across = cornerAt(place).across;
        return across != kNone && receivers[across] == receivers[place.piece];
    };
    const auto next = [&](Place place) {
        place.edge.corner = after(place.edge.corner, m_pieces[place.piece].rings[place.edge.ring]);
        return place;
    };
    const auto following = [&](Place place) {
        place = next(place);
        while (isWithin(place)) {
            const PieceCorner& corner = cornerAt(place);
            place = next({corner.across, edgeOf(corner.across, cornerAt(next(place)).point, corner.point)});
        }
        return place;
    };

    PieceRings boundary;
    std::vector<std::vector<std::vector<bool>>> isTaken(group.size());  // of each corner
    const auto mark = [&](const Place& place) {
        const auto member = static_cast<std::size_t>(std::ranges::lower_bound(group, place.piece) - group.begin());
        if (isTaken[member].empty()) {
            for (const PieceRing& ring : m_pieces[place.piece].rings) isTaken[member].emplace_back(ring.size(), false);
        }
        return isTaken[member][place.edge.ring][place.edge.corner];
    };
    for (const std::uint32_t piece : group) {
        for (std::size_t ring = 0; ring < m_pieces[piece].rings.size(); ++ring) {
            for (std::size_t corner = 0; corner < m_pieces[piece].rings[ring].size(); ++corner) {
                Place place{piece, {ring, corner}};
                if (isWithin(place) || mark(place)) continue;
                PieceRing& way = boundary.emplace_back();
                for (; !mark(place); place = following(place)) {
                    mark(place) = true;
                    way.push_back(cornerAt(place));
                }
            }
        }
    }
    return boundary;
}

void PieceDraft::merge(std::span<const std::uint32_t> receivers) {
    std::vector<std::vector<std::uint32_t>> groups(m_pieces.size());  // those with more than one member, by receiver
    for (std::uint32_t piece = 0; piece < m_pieces.size(); ++piece) {
        if (receivers[piece] == piece || !isThere(piece)) continue;
        std::vector<std::uint32_t>& group = groups[receivers[piece]];
        if (group.empty()) group.push_back(receivers[piece]);
        group.push_back(piece);
    }
    std::vector<PieceRings> merged(m_pieces.size());
    for (std::uint32_t receiver = 0; receiver < m_pieces.size(); ++receiver) {
        if (groups[receiver].empty()) continue;
        std::ranges::sort(groups[receiver]);
        merged[receiver] = onePiece(boundaryOf(groups[receiver], receivers), m_partition.points);
    }
    for (std::uint32_t receiver = 0; receiver < m_pieces.size(); ++receiver) {
        for (const std::uint32_t member : groups[receiver]) m_pieces[member].rings.clear();
        if (!groups[receiver].empty()) m_pieces[receiver].rings = std::move(merged[receiver]);
    }
    for (Piece& piece : m_pieces) {
        for (PieceRing& ring : piece.rings) {
            for (PieceCorner& corner : ring) {
                if (corner.across != kNone) corner.across = receivers[corner.across];
            }
        }
    }
}

Partition PieceDraft::finished() && {
    std::vector<std::uint32_t> firstOfSeed(m_partition.pieceOfSeed.size() + 1, kNone);  // the last: of no seed
    const auto firstPlace = [&](std::uint32_t piece) -> std::uint32_t& {
        const std::uint32_t seed = seedOf(piece);
        return firstOfSeed[seed == kNone ? firstOfSeed.size() - 1 : seed];
    };
    std::vector<std::uint32_t> order;
    for (std::uint32_t piece = 0; piece < count(); ++piece) {
        if (!isThere(piece)) continue;
        order.push_back(piece);
        if (firstPlace(piece) == kNone) firstPlace(piece) = piece;
    }
    std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
        if (firstPlace(a) != firstPlace(b)) return firstPlace(a) < firstPlace(b);
        if (!areNamesakes(a, b)) return std::ranges::lexicographical_compare(cutCellsOf(a), cutCellsOf(b));
        return std::pair(m_pieces[a].part, a) < std::pair(m_pieces[b].part, b);
    });
    std::vector<std::uint32_t> numbers(count(), kNone);
    for (std::uint32_t k = 0; k < order.size(); ++k) numbers[order[k]] = k;

    Partition result{.origin = m_partition.origin, .points = std::move(m_partition.points)};
    result.gap = m_partition.gap;
    result.reports = std::move(m_partition.reports);
    result.cutLayers = m_partition.cutLayers;
    result.pieceOfSeed.assign(m_partition.pieceOfSeed.size(), kNone);
    result.ringsOfPiece = {0};
    result.cornersOfRing = {0};
    for (const std::uint32_t piece : order) {
        const std::uint32_t seed = seedOf(piece);
        if (seed != kNone && result.pieceOfSeed[seed] == kNone) result.pieceOfSeed[seed] = numbers[piece];
        result.seedOfPiece.push_back(seed);
        result.partOfCell.push_back(m_pieces[piece].part);
        for (const std::uint32_t cell : cutCellsOf(piece)) result.cutCells.push_back(cell);
        append(m_pieces[piece].rings, numbers, result);
    }
    return result;
}

}  // namespace rubble
