#include "core/fracture/partition/VertexWelding.h"

#include "core/base/DisjointSets.h"
#include "core/fracture/partition/EdgeIndex.h"
#include "core/fracture/partition/PieceRings.h"
#include "core/geometry/polygon/IndexedCorners.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

namespace rubble {
namespace {

/// The representative of each point. Of two points the outline vertex stays, else the lower one; two outline vertices
/// are never merged.
std::vector<std::uint32_t> weldedPoints(std::size_t count, const Coincidences& coincidences) {
    const auto isFixed = [&](std::uint32_t p) { return p >= coincidences.fixedBegin && p < coincidences.fixedEnd; };
    DisjointSets sets(count);
    for (const auto& [first, second] : coincidences.pairs) {
        std::uint32_t a = sets.rootOf(first), b = sets.rootOf(second);
        if (a == b || (isFixed(a) && isFixed(b))) continue;
        if (isFixed(b) || (!isFixed(a) && b < a)) std::swap(a, b);
        sets.mergeInto(a, b);
    }
    return sets.roots();
}

/// Whether a point lies on the open segment, within `distance`.
bool liesOn(Vec2 point, Vec2 from, Vec2 to, double distance) {
    const Vec2 edge = to - from, offset = point - from;
    const double squared = edge.x * edge.x + edge.y * edge.y;
    const double along = edge.x * offset.x + edge.y * offset.y;
    return along > 0.0 && along < squared && std::abs(cross(edge, offset)) <= distance * std::sqrt(squared);
}

/// Adds touching vertices that lie at the end of an edge to the coincident pairs.
void pairTouchesAtEnds(const Partition& p, Coincidences& coincidences) {
    for (const TouchingVertex& touch : coincidences.touches) {
        for (std::uint32_t ring = p.ringsOfPiece[touch.firstPiece]; ring < p.ringsOfPiece[touch.lastPiece + 1];
             ++ring) {
            for (const std::uint32_t corner : p.ringCorners(ring)) {
                const Vec2 offset = p.points[corner] - p.points[touch.point];
                const bool isNear =
                    std::abs(offset.x) <= coincidences.weldDistance && std::abs(offset.y) <= coincidences.weldDistance;
                if (isNear && corner != touch.point) coincidences.pairs.push_back({corner, touch.point});
            }
        }
    }
}

/// Welds the points of all pieces and removes what has no width: of two opposite edges of a piece both are removed, and
/// the pieces behind them become neighbours.
class Welder {
public:
    Welder(Partition& partition, const Coincidences& coincidences)
        : m_partition(partition),
          m_welded(weldedPoints(partition.points.size(), coincidences)),
          m_distance(coincidences.weldDistance),
          m_isSuspect(partition.pieceCount(), false) {
        for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) addPiece(piece);
        for (const TouchingVertex& touch : coincidences.touches) splitAtTouch(touch);
    }

    /// Returns the number of edges visited.
    std::size_t run() {
        for (std::size_t next = 0; next < m_suspects.size(); ++next) {
            const std::uint32_t piece = m_suspects[next];
            m_isSuspect[piece] = false;
            while (cancelOpposite(piece) || splitAtSpike(piece)) {
            }
        }
        writeBack();
        return m_visited;
    }

private:
    /// A piece of the result, and the piece that it comes from.
    struct NewPiece {
        PieceRings rings;
        std::uint32_t source;
        Vec2 smallest;
    };

    void addPiece(std::uint32_t piece) {
        PieceRings rings;
        for (std::uint32_t ring = m_partition.ringsOfPiece[piece]; ring < m_partition.ringsOfPiece[piece + 1]; ++ring) {
            const std::uint32_t begin = m_partition.cornersOfRing[ring], end = m_partition.cornersOfRing[ring + 1];
            PieceRing loop;
            for (std::uint32_t corner = begin; corner < end; ++corner) {
                const std::uint32_t point = m_welded[m_partition.corners[corner]];
                const std::uint32_t next = m_welded[m_partition.corners[corner + 1 < end ? corner + 1 : begin]];
                if (point != next)
                    loop.push_back({point, m_partition.neighbours[corner]});
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

    /// Inserts a touching vertex into the edges that it lies on.
    void splitAtTouch(const TouchingVertex& touch) {
        const std::uint32_t vertex = m_welded[touch.point];
        for (std::uint32_t piece = touch.firstPiece; piece <= touch.lastPiece; ++piece) {
            suspect(piece);
            for (std::size_t ring = 0; ring < m_rings[piece].size(); ++ring) {
                for (std::size_t i = 0; i < m_rings[piece][ring].size(); ++i) {
                    const PieceRing& loop = m_rings[piece][ring];
                    const PieceCorner start = loop[i], end = loop[(i + 1) % loop.size()];
                    const bool isInside = start.neighbour != kNone && start.point != vertex && end.point != vertex;
                    if (isInside && lies(vertex, start.point, end.point)) splitEdge(piece, ring, i, vertex);
                }
            }
        }
    }

    Vec2 at(std::uint32_t point) const { return m_partition.points[point]; }
    bool lies(std::uint32_t point, std::uint32_t from, std::uint32_t to) const {
        return liesOn(at(point), at(from), at(to), m_distance);
    }

    /// At a spike, where the ring turns back at b in ... a, b, c ... and c lies on the edge a b or a on the edge b c,
    /// splits that edge so that parts of both are opposite. False where there is no spike. A point splits the edges of
    /// a piece only once: where many narrow cells meet, spikes would otherwise move from one to the next for ever.
    bool splitAtSpike(std::uint32_t piece) {
        for (std::size_t ring = 0; ring < m_rings[piece].size(); ++ring) {
            const PieceRing& loop = m_rings[piece][ring];
            const std::size_t size = loop.size();
            m_visited += size;
            for (std::size_t i = 0; i < size; ++i) {
                const std::size_t before = (i + size - 1) % size;
                const std::uint32_t a = loop[before].point, b = loop[i].point, c = loop[(i + 1) % size].point;
                if (lies(c, a, b) && m_spikes.insert({piece, c}).second) return splitEdge(piece, ring, before, c);
                if (lies(a, b, c) && m_spikes.insert({piece, a}).second) return splitEdge(piece, ring, i, a);
            }
        }
        return false;
    }

    /// Inserts a point into the edge that starts at a corner, in both pieces.
    bool splitEdge(std::uint32_t piece, std::size_t ring, std::size_t corner, std::uint32_t point) {
        PieceRing& loop = m_rings[piece][ring];
        const PieceCorner start = loop[corner];
        const std::uint32_t end = loop[(corner + 1) % loop.size()].point;
        insertAfter(loop, corner, point);
        if (start.neighbour != kNone) {
            if (const std::optional<RingEdge> reverse = findEdge(start.neighbour, {end, start.point})) {
                insertAfter(m_rings[start.neighbour][reverse->ring], reverse->corner, point);
                suspect(start.neighbour);
            }
        }
        return true;
    }

    static void insertAfter(PieceRing& loop, std::size_t corner, std::uint32_t point) {
        loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(corner) + 1, {point, loop[corner].neighbour});
    }

    std::optional<RingEdge> findEdge(std::uint32_t piece, PointEdge edge) {
        m_visited += cornerCount(piece);
        return rubble::findEdge(m_rings[piece], edge);
    }
    std::size_t cornerCount(std::uint32_t piece) const {
        std::size_t count = 0;
        for (const PieceRing& ring : m_rings[piece]) count += ring.size();
        return count;
    }

    struct OppositeEdges {
        RingEdge forward;
        RingEdge back;
    };
    /// The first edge of a piece that has an opposite one, with the first of these; nothing if there is none.
    std::optional<OppositeEdges> findOpposite(std::uint32_t piece) {
        constexpr std::size_t kMaxCompared = 32;  // corners; larger pieces are sorted
        const std::size_t count = cornerCount(piece);
        m_visited += count;
        if (count <= kMaxCompared)
            return findOppositeAmong(piece, [&](std::uint32_t from, std::uint32_t to) {
                return rubble::findEdge(m_rings[piece], {from, to});
            });
        struct Entry {
            std::uint32_t from, to;
            std::size_t ring, corner;
            auto operator<=>(const Entry&) const = default;
        };
        std::vector<Entry> entries;
        entries.reserve(count);
        const PieceRings& rings = m_rings[piece];
        for (std::size_t ring = 0; ring < rings.size(); ++ring) {
            for (std::size_t i = 0; i < rings[ring].size(); ++i)
                entries.push_back({rings[ring][i].point, rings[ring][nextCorner(rings[ring], i)].point, ring, i});
        }
        std::ranges::sort(entries);
        return findOppositeAmong(piece, [&](std::uint32_t from, std::uint32_t to) -> std::optional<RingEdge> {
            const auto found = std::ranges::lower_bound(entries, Entry{from, to, 0, 0});
            if (found == entries.end() || found->from != from || found->to != to) return std::nullopt;
            return RingEdge{found->ring, found->corner};
        });
    }
    template <class Find>
    std::optional<OppositeEdges> findOppositeAmong(std::uint32_t piece, Find find) const {
        const PieceRings& rings = m_rings[piece];
        for (std::size_t ring = 0; ring < rings.size(); ++ring) {
            for (std::size_t i = 0; i < rings[ring].size(); ++i) {
                const std::uint32_t end = rings[ring][nextCorner(rings[ring], i)].point;
                if (const auto back = find(end, rings[ring][i].point)) return OppositeEdges{{ring, i}, *back};
            }
        }
        return std::nullopt;
    }

    /// Removes two opposite edges a -> b and b -> a of a piece. In one ring that splits it; in two it merges them.
    bool cancelOpposite(std::uint32_t piece) {
        const std::optional<OppositeEdges> opposite = findOpposite(piece);
        if (!opposite) return false;
        PieceRings& rings = m_rings[piece];
        const PieceCorner a = rings[opposite->forward.ring][opposite->forward.corner];
        const PieceCorner b = rings[opposite->back.ring][opposite->back.corner];
        cancel(rings, opposite->forward, opposite->back);
        setNeighbour(a.neighbour, b.point, a.point, b.neighbour);
        setNeighbour(b.neighbour, a.point, b.point, a.neighbour);
        return true;
    }

    static void cancel(PieceRings& rings, RingEdge forward, RingEdge back) {
        // Each ring rotated so that it starts after its edge: from b ... to a, and from a ... to b.
        const auto rotated = [&](RingEdge edge) {
            PieceRing loop = std::move(rings[edge.ring]);
            std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>((edge.corner + 1) % loop.size()),
                        loop.end());
            return loop;
        };
        if (forward.ring != back.ring) {
            const PieceRing first = rotated(forward), second = rotated(back);
            PieceRing merged(first.begin(), first.end() - 1);
            merged.insert(merged.end(), second.begin(), second.end() - 1);
            rings[forward.ring] = std::move(merged);
            rings[back.ring].clear();
            return;
        }
        const std::size_t size = rings[forward.ring].size();
        const std::size_t backCorner = (back.corner + size - (forward.corner + 1)) % size;  // after the rotation
        const PieceRing whole = rotated(forward);
        rings[forward.ring].assign(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(backCorner));
        rings.emplace_back(whole.begin() + static_cast<std::ptrdiff_t>(backCorner) + 1, whole.end() - 1);
    }

    void setNeighbour(std::uint32_t piece, std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
        if (piece == kNone) return;
        if (const std::optional<RingEdge> edge = findEdge(piece, {from, to}))
            m_rings[piece][edge->ring][edge->corner].neighbour = neighbour;
        if (piece == neighbour) suspect(piece);
    }

    /// The pieces of the result that come from one piece: mostly one, none if it had no width, several if it was
    /// disconnected.
    std::vector<NewPiece> newPieces(std::uint32_t source) {
        std::vector<NewPiece> pieces;
        for (PieceRings& rings : connectedParts(std::move(m_rings[source]), m_partition.points)) {
            Vec2 smallest = at(rings[0][0].point);
            for (const PieceCorner& corner : rings[0])
                smallest = std::min(smallest, at(corner.point), lexicographicLess);
            pieces.push_back({std::move(rings), source, smallest});
        }
        return pieces;
    }

    void writeBack() {
        Partition& p = m_partition;
        const UninitializedVector<std::uint32_t> seeds = std::move(p.seedOfPiece);
        p.ringsOfPiece.assign(1, 0);
        p.seedOfPiece.clear();
        p.cornersOfRing.assign(1, 0);
        p.corners.clear();
        p.neighbours.clear();
        std::vector<std::vector<std::uint32_t>> newPiecesOf(seeds.size());
        for (std::uint32_t piece = 0; piece < seeds.size();) {
            std::vector<NewPiece> ofSeed;
            const std::uint32_t seed = seeds[piece];
            for (; piece < seeds.size() && seeds[piece] == seed; ++piece) {
                std::vector<NewPiece> pieces = newPieces(piece);
                std::move(pieces.begin(), pieces.end(), std::back_inserter(ofSeed));
            }
            std::stable_sort(ofSeed.begin(), ofSeed.end(), [](const NewPiece& a, const NewPiece& b) {
                return lexicographicLess(a.smallest, b.smallest);
            });
            for (const NewPiece& newPiece : ofSeed) {
                newPiecesOf[newPiece.source].push_back(p.pieceCount());
                append(newPiece, seed);
            }
        }
        renameNeighbours(newPiecesOf);
    }

    void append(const NewPiece& piece, std::uint32_t seed) {
        Partition& p = m_partition;
        for (const PieceRing& loop : piece.rings) {
            for (const PieceCorner& corner : loop) {
                p.corners.push_back(corner.point);
                p.neighbours.push_back(corner.neighbour);
            }
            p.cornersOfRing.push_back(static_cast<std::uint32_t>(p.corners.size()));
        }
        p.ringsOfPiece.push_back(static_cast<std::uint32_t>(p.cornersOfRing.size()) - 1);
        p.seedOfPiece.push_back(seed);
    }

    void renameNeighbours(const std::vector<std::vector<std::uint32_t>>& newPiecesOf) {
        Partition& p = m_partition;
        EdgeIndex index;
        for (std::uint32_t source = 0; source < newPiecesOf.size(); ++source) {
            if (newPiecesOf[source].size() <= EdgeIndex::kMaxLinear) continue;
            for (const std::uint32_t piece : newPiecesOf[source]) index.add(p, {.group = source, .piece = piece});
        }
        index.sort();
        for (std::uint32_t ring = 0; ring + 1 < p.cornersOfRing.size(); ++ring) {
            const std::uint32_t begin = p.cornersOfRing[ring], end = p.cornersOfRing[ring + 1];
            for (std::uint32_t corner = begin; corner < end; ++corner) {
                if (p.neighbours[corner] == kNone) continue;
                const std::vector<std::uint32_t>& candidates = newPiecesOf[p.neighbours[corner]];
                const std::uint32_t next = p.corners[corner + 1 < end ? corner + 1 : begin];
                if (candidates.size() > EdgeIndex::kMaxLinear) {
                    p.neighbours[corner] = index.find(p.neighbours[corner], {next, p.corners[corner]});
                    continue;
                }
                const auto found = std::find_if(candidates.begin(), candidates.end(), [&](std::uint32_t piece) {
                    return candidates.size() == 1 || hasEdge(p, piece, {next, p.corners[corner]});
                });
                p.neighbours[corner] = found == candidates.end() ? kNone : *found;
            }
        }
    }

    Partition& m_partition;
    const std::vector<std::uint32_t> m_welded;  // the representative of each point
    double m_distance;
    std::vector<PieceRings> m_rings;        // of each piece
    std::vector<std::uint32_t> m_suspects;  // pieces that may have parts without width; grows while it is visited
    std::set<std::array<std::uint32_t, 2>> m_spikes;  // {piece, point} that has split its edges
    std::vector<bool> m_isSuspect;                    // those still queued
    std::size_t m_visited = 0;                        // edges
};

}  // namespace

std::size_t weldVertices(Partition& partition, Coincidences coincidences) {
    pairTouchesAtEnds(partition, coincidences);
    return Welder(partition, coincidences).run();
}

}  // namespace rubble
