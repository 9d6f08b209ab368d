#include "core/fracture/PartitionRepair.h"

#include "core/fracture/PieceRings.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>

namespace rubble {

namespace {

/// The points after joining: each names the one that stands for it.
class JoinedPoints {
public:
    JoinedPoints(std::size_t count, const Coincidences& coincidences) : m_parents(count) {
        std::iota(m_parents.begin(), m_parents.end(), 0u);
        for (const auto& [a, b] : coincidences.pairs) join(rootOf(a), rootOf(b), coincidences);
        for (std::uint32_t point = 0; point < m_parents.size(); ++point) m_parents[point] = rootOf(point);
    }
    std::uint32_t operator[](std::uint32_t point) const { return m_parents[point]; }

private:
    std::uint32_t rootOf(std::uint32_t point) {
        while (m_parents[point] != point) point = m_parents[point] = m_parents[m_parents[point]];
        return point;
    }
    /// An outline vertex stands for others, and never gives way to another one.
    void join(std::uint32_t a, std::uint32_t b, const Coincidences& coincidences) {
        const auto isKept = [&](std::uint32_t p) { return p >= coincidences.keptBegin && p < coincidences.keptEnd; };
        if (a == b || (isKept(a) && isKept(b))) return;
        if (isKept(b) || (!isKept(a) && b < a)) std::swap(a, b);
        m_parents[b] = a;
    }

    std::vector<std::uint32_t> m_parents;
};

bool isSmaller(Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// Whether a point is so near to the open segment that it lies on it.
bool liesOn(Vec2 point, Vec2 from, Vec2 to, double distance) {
    const Vec2 edge = to - from, offset = point - from;
    const double squared = edge.x * edge.x + edge.y * edge.y;
    const double along = edge.x * offset.x + edge.y * offset.y;
    return along > 0.0 && along < squared && std::abs(cross(edge, offset)) <= distance * std::sqrt(squared);
}

/// Touching vertices that lie at an end of an edge are pairs too.
void pairTouchesAtEnds(const Partition& p, Coincidences& coincidences) {
    for (const TouchingVertex& touch : coincidences.touches) {
        for (std::uint32_t ring = p.ringsOfPiece[touch.firstPiece]; ring < p.ringsOfPiece[touch.lastPiece + 1];
             ++ring) {
            for (const std::uint32_t corner : p.ringCorners(ring)) {
                const Vec2 offset = p.points[corner] - p.points[touch.point];
                const bool isNear =
                    std::abs(offset.x) <= coincidences.distance && std::abs(offset.y) <= coincidences.distance;
                if (isNear && corner != touch.point) coincidences.pairs.push_back({corner, touch.point});
            }
        }
    }
}

/// Takes away what has no width: two edges of a piece that run along each other in opposite directions go, and what lies
/// behind the one now touches what lies behind the other.
class Repair {
public:
    Repair(Partition& partition, const Coincidences& coincidences)
        : m_partition(partition),
          m_joined(partition.points.size(), coincidences),
          m_distance(coincidences.distance),
          m_isSuspect(partition.pieceCount(), false) {
        for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) takePiece(piece);
        for (const TouchingVertex& touch : coincidences.touches) splitAtTouch(touch);
    }

    void run() {
        for (std::size_t next = 0; next < m_suspects.size(); ++next) {
            const std::uint32_t piece = m_suspects[next];
            m_isSuspect[piece] = false;
            while (cancelOpposite(piece) || splitAtSpike(piece)) {
            }
        }
        writeBack();
    }

private:
    /// A piece as it goes back, and the piece it was.
    struct NewPiece {
        PieceRings rings;
        std::uint32_t was;
        Vec2 smallest;
    };

    void takePiece(std::uint32_t piece) {
        PieceRings rings;
        for (std::uint32_t ring = m_partition.ringsOfPiece[piece]; ring < m_partition.ringsOfPiece[piece + 1]; ++ring) {
            const std::uint32_t begin = m_partition.cornersOfRing[ring], end = m_partition.cornersOfRing[ring + 1];
            PieceRing loop;
            for (std::uint32_t corner = begin; corner < end; ++corner) {
                const std::uint32_t point = m_joined[m_partition.corners[corner]];
                const std::uint32_t next = m_joined[m_partition.corners[corner + 1 < end ? corner + 1 : begin]];
                if (point != next)
                    loop.push_back({point, m_partition.across[corner]});
                else
                    suspect(piece);
            }
            rings.push_back(std::move(loop));
        }
        m_rings.push_back(std::move(rings));
    }

    void suspect(std::uint32_t piece) {
        if (piece == kNone || m_isSuspect[piece]) return;
        m_isSuspect[piece] = true;
        m_suspects.push_back(piece);
    }

    /// Makes a touching vertex a corner of the edges that it lies on.
    void splitAtTouch(const TouchingVertex& touch) {
        const std::uint32_t vertex = m_joined[touch.point];
        for (std::uint32_t piece = touch.firstPiece; piece <= touch.lastPiece; ++piece) {
            suspect(piece);
            for (std::size_t ring = 0; ring < m_rings[piece].size(); ++ring) {
                for (std::size_t i = 0; i < m_rings[piece][ring].size(); ++i) {
                    const PieceRing& loop = m_rings[piece][ring];
                    const PieceCorner start = loop[i], end = loop[(i + 1) % loop.size()];
                    const bool isInside = start.across != kNone && start.point != vertex && end.point != vertex;
                    if (isInside && lies(vertex, start.point, end.point)) splitEdge(piece, ring, i, vertex);
                }
            }
        }
    }

    Vec2 at(std::uint32_t point) const { return m_partition.points[point]; }
    bool lies(std::uint32_t point, std::uint32_t from, std::uint32_t to) const {
        return liesOn(at(point), at(from), at(to), m_distance);
    }

    /// Where a ring turns back at a corner b, ... a, b, c ..., and c lies on the edge a b or a on the edge b c, splits that
    /// edge so that parts of both run along each other. False where there is no such corner. A point parts the edges of
    /// a piece once: where many narrow cells meet, their tips would go from one to the next for ever.
    bool splitAtSpike(std::uint32_t piece) {
        for (std::size_t ring = 0; ring < m_rings[piece].size(); ++ring) {
            const PieceRing& loop = m_rings[piece][ring];
            const std::size_t size = loop.size();
            for (std::size_t i = 0; i < size; ++i) {
                const std::size_t before = (i + size - 1) % size;
                const std::uint32_t a = loop[before].point, b = loop[i].point, c = loop[(i + 1) % size].point;
                if (lies(c, a, b) && m_spikes.insert({piece, c}).second) return splitEdge(piece, ring, before, c);
                if (lies(a, b, c) && m_spikes.insert({piece, a}).second) return splitEdge(piece, ring, i, a);
            }
        }
        return false;
    }

    /// Puts a point into the edge that starts at a corner, on both of its sides.
    bool splitEdge(std::uint32_t piece, std::size_t ring, std::size_t corner, std::uint32_t point) {
        PieceRing& loop = m_rings[piece][ring];
        const PieceCorner start = loop[corner];
        const std::uint32_t end = loop[(corner + 1) % loop.size()].point;
        insertAfter(loop, corner, point);
        if (start.across != kNone) {
            if (const std::optional<Edge> reverse = findEdge(start.across, end, start.point)) {
                insertAfter(m_rings[start.across][reverse->ring], reverse->corner, point);
                suspect(start.across);
            }
        }
        return true;
    }

    static void insertAfter(PieceRing& loop, std::size_t corner, std::uint32_t point) {
        loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(corner) + 1, {point, loop[corner].across});
    }

    /// Which edge of a piece: the one that starts at a corner of a ring.
    struct Edge {
        std::size_t ring;
        std::size_t corner;
    };
    std::optional<Edge> findEdge(std::uint32_t piece, std::uint32_t from, std::uint32_t to) const {
        const PieceRings& rings = m_rings[piece];
        for (std::size_t ring = 0; ring < rings.size(); ++ring) {
            for (std::size_t i = 0; i < rings[ring].size(); ++i) {
                if (rings[ring][i].point == from && rings[ring][(i + 1) % rings[ring].size()].point == to)
                    return Edge{ring, i};
            }
        }
        return std::nullopt;
    }

    /// Takes two edges a -> b and b -> a out of a piece. In one ring they part it in two; in two they join them.
    bool cancelOpposite(std::uint32_t piece) {
        PieceRings& rings = m_rings[piece];
        for (std::size_t ring = 0; ring < rings.size(); ++ring) {
            for (std::size_t i = 0; i < rings[ring].size(); ++i) {
                const PieceCorner a = rings[ring][i];
                const std::uint32_t b = rings[ring][(i + 1) % rings[ring].size()].point;
                const std::optional<Edge> reverse = findEdge(piece, b, a.point);
                if (!reverse) continue;
                const std::uint32_t behind = rings[reverse->ring][reverse->corner].across;
                cancel(rings, {ring, i}, *reverse);
                name(a.across, b, a.point, behind);
                name(behind, a.point, b, a.across);
                return true;
            }
        }
        return false;
    }

    static void cancel(PieceRings& rings, Edge forward, Edge back) {
        // Each ring turned so that it starts behind its edge: from b ... to a, and from a ... to b.
        const auto turned = [&](Edge edge) {
            PieceRing loop = std::move(rings[edge.ring]);
            std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>((edge.corner + 1) % loop.size()),
                        loop.end());
            return loop;
        };
        if (forward.ring != back.ring) {
            const PieceRing first = turned(forward), second = turned(back);
            PieceRing joined(first.begin(), first.end() - 1);
            joined.insert(joined.end(), second.begin(), second.end() - 1);
            rings[forward.ring] = std::move(joined);
            rings[back.ring].clear();
            return;
        }
        const std::size_t size = rings[forward.ring].size();
        const std::size_t backCorner = (back.corner + size - (forward.corner + 1)) % size;  // once turned
        const PieceRing whole = turned(forward);
        rings[forward.ring].assign(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(backCorner));
        rings.emplace_back(whole.begin() + static_cast<std::ptrdiff_t>(backCorner) + 1, whole.end() - 1);
    }

    /// Says what lies behind a piece's edge from now on.
    void name(std::uint32_t piece, std::uint32_t from, std::uint32_t to, std::uint32_t across) {
        if (piece == kNone) return;
        if (const std::optional<Edge> edge = findEdge(piece, from, to))
            m_rings[piece][edge->ring][edge->corner].across = across;
        if (piece == across) suspect(piece);
    }

    /// What became of a piece: mostly one piece, none where it had no width, several where points cut it apart.
    std::vector<NewPiece> newPieces(std::uint32_t was) {
        std::vector<NewPiece> pieces;
        for (PieceRings& rings : connectedParts(std::move(m_rings[was]), m_partition.points)) {
            Vec2 smallest = at(rings[0][0].point);
            for (const PieceCorner& corner : rings[0]) smallest = std::min(smallest, at(corner.point), isSmaller);
            pieces.push_back({std::move(rings), was, smallest});
        }
        return pieces;
    }

    void writeBack() {
        Partition& p = m_partition;
        const RawVector<std::uint32_t> seeds = std::move(p.seedOfPiece);
        p.ringsOfPiece.assign(1, 0);
        p.seedOfPiece.clear();
        p.cornersOfRing.assign(1, 0);
        p.corners.clear();
        p.across.clear();
        std::vector<std::vector<std::uint32_t>> became(seeds.size());
        for (std::uint32_t piece = 0; piece < seeds.size();) {
            std::vector<NewPiece> ofSeed;
            const std::uint32_t seed = seeds[piece];
            for (; piece < seeds.size() && seeds[piece] == seed; ++piece) {
                std::vector<NewPiece> pieces = newPieces(piece);
                std::move(pieces.begin(), pieces.end(), std::back_inserter(ofSeed));
            }
            std::stable_sort(ofSeed.begin(), ofSeed.end(),
                             [](const NewPiece& a, const NewPiece& b) { return isSmaller(a.smallest, b.smallest); });
            for (const NewPiece& newPiece : ofSeed) {
                became[newPiece.was].push_back(p.pieceCount());
                append(newPiece, seed);
            }
        }
        renameNeighbours(became);
    }

    void append(const NewPiece& piece, std::uint32_t seed) {
        Partition& p = m_partition;
        for (const PieceRing& loop : piece.rings) {
            for (const PieceCorner& corner : loop) {
                p.corners.push_back(corner.point);
                p.across.push_back(corner.across);
            }
            p.cornersOfRing.push_back(static_cast<std::uint32_t>(p.corners.size()));
        }
        p.ringsOfPiece.push_back(static_cast<std::uint32_t>(p.cornersOfRing.size()) - 1);
        p.seedOfPiece.push_back(seed);
    }

    void renameNeighbours(const std::vector<std::vector<std::uint32_t>>& became) {
        Partition& p = m_partition;
        for (std::uint32_t ring = 0; ring + 1 < p.cornersOfRing.size(); ++ring) {
            const std::uint32_t begin = p.cornersOfRing[ring], end = p.cornersOfRing[ring + 1];
            for (std::uint32_t corner = begin; corner < end; ++corner) {
                if (p.across[corner] == kNone) continue;
                const std::vector<std::uint32_t>& candidates = became[p.across[corner]];
                const std::uint32_t next = p.corners[corner + 1 < end ? corner + 1 : begin];
                const auto found = std::find_if(candidates.begin(), candidates.end(), [&](std::uint32_t piece) {
                    return candidates.size() == 1 || hasEdge(p, piece, next, p.corners[corner]);
                });
                p.across[corner] = found == candidates.end() ? kNone : *found;
            }
        }
    }

    Partition& m_partition;
    JoinedPoints m_joined;
    double m_distance;
    std::vector<PieceRings> m_rings;        // of each piece
    std::vector<std::uint32_t> m_suspects;  // pieces that may have parts without width; grows while it is gone through
    std::set<std::array<std::uint32_t, 2>> m_spikes;  // {piece, point} that has parted its edges
    std::vector<bool> m_isSuspect;                    // those that wait their turn
};

}  // namespace

void joinCoincidences(Partition& partition, Coincidences coincidences) {
    pairTouchesAtEnds(partition, coincidences);
    Repair(partition, coincidences).run();
}

}  // namespace rubble
