#include "core/fracture/Fragment.h"

#include "core/base/Parallel.h"
#include "core/fracture/PieceParts.h"
#include "core/fracture/ThinPieces.h"
#include "core/fracture/VoronoiPartition.h"
#include "core/geometry/NumberedCorners.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <atomic>

namespace rubble {
namespace {

constexpr std::size_t kBlock = 128;  // fragments that a thread makes between two looks at the cancel token
constexpr double kThinnest = 1e-9;   // of the outline's width
constexpr double kFlat = 1e-12;      // of the outline's diameter: far above the rounding of constructed points

/// What becomes of a piece.
struct Place {
    std::uint32_t fragment = 0;      // its index; that of the receiver where it is too thin
    std::uint32_t index = 0;         // among the pieces of its seed
    std::uint32_t piecesOfSeed = 1;  // thin ones too
    bool isThin = false;
};

/// Numbers fragments by seed, then by piece, with none for thin pieces. Gives how many there are.
std::uint32_t numberFragments(const Partition& partition, std::vector<Place>& places) {
    if (partition.pieceOfSeed.empty()) return partition.pieceCount();  // the outline, unbroken
    std::uint32_t count = 0;
    for (const std::uint32_t first : partition.pieceOfSeed) {
        if (first == kNone) continue;
        std::uint32_t end = first + 1;
        while (end < places.size() && partition.seedOfPiece[end] == partition.seedOfPiece[first]) ++end;
        for (std::uint32_t piece = first; piece < end; ++piece) {
            Place& place = places[piece];
            place.index = piece - first;
            place.piecesOfSeed = end - first;
            place.fragment = place.isThin ? kNone : count++;
        }
    }
    return count;
}

void sortByFragmentAndJoin(double least, double depth, std::vector<Bond>& bonds) {
    std::sort(bonds.begin(), bonds.end(), [](const Bond& a, const Bond& b) {
        return a.fragment != b.fragment ? a.fragment < b.fragment : a.area < b.area;
    });
    std::size_t count = 0;
    for (std::size_t i = 0; i < bonds.size();) {
        Bond joined{bonds[i].fragment, 0.0};
        for (; i < bonds.size() && bonds[i].fragment == joined.fragment; ++i) joined.area += bonds[i].area;
        if (joined.area <= least) continue;
        joined.area *= depth;
        bonds[count++] = joined;
    }
    bonds.resize(count);
}

/// Makes fragments from pieces, of which some may have been found too thin to become one.
class Extrusion {
public:
    Extrusion(const Prism& prism, const Partition& partition)
        : m_partition(partition), m_depth(prism.depth), m_places(partition.pieceCount()) {
        const double diameter = boundsOf(prism.outline.outer).diagonal();
        m_tolerance = {kThinnest * widthOf(prism.outline), kFlat * diameter};
        m_leastEdge = kLeastSharedEdge * diameter;
    }

    /// Makes one fragment a piece, but for thin ones. Makes all again when thin pieces are found, as their neighbours
    /// change. False where the task was cancelled.
    bool run(const TaskContext& task) {
        while (true) {
            m_fragments = std::vector<Fragment>(numberFragments(m_partition, m_places));
            for (const ThinPieceGift& gift : m_gifts) {
                if (gift.receiver != kNone) m_places[gift.thin].fragment = m_places[gift.receiver].fragment;
            }
            std::atomic<bool> isAnyThin = false;
            forEachIndex((m_places.size() + kBlock - 1) / kBlock, task.threads, [&](std::size_t block) {
                if (task.isCancelled()) return;
                if (!makeBlock(block * kBlock)) isAnyThin = true;
            });
            if (task.isCancelled()) return false;
            if (!isAnyThin) return true;
            giveAwayThinPieces();
        }
    }

    Fragments result() {
        Fragments result{std::move(m_fragments), m_partition.reports};
        for (const ThinPieceGift& gift : m_gifts) result.reports.push_back(thinPieceReport(m_partition, gift));
        return result;
    }

private:
    /// Makes the fragments of a block of pieces, as they stand in memory. False where one was found to be thin.
    bool makeBlock(std::size_t begin) {
        const auto end = static_cast<std::uint32_t>(std::min(m_places.size(), begin + kBlock));
        bool isAnyThin = false;
        for (auto piece = static_cast<std::uint32_t>(begin); piece < end; ++piece) {
            Place& place = m_places[piece];
            if (place.isThin || make(piece, m_fragments[place.fragment])) continue;
            place.isThin = isAnyThin = true;
        }
        return !isAnyThin;
    }

    void giveAwayThinPieces() {
        std::vector<std::uint32_t> thin;
        for (std::uint32_t piece = 0; piece < m_places.size(); ++piece) {
            if (m_places[piece].isThin) thin.push_back(piece);
        }
        std::ranges::stable_sort(thin, {}, [&](std::uint32_t piece) { return m_partition.seedOfPiece[piece]; });
        m_gifts = thinPieceGifts(m_partition, thin);
    }

    /// False where the piece is too thin.
    bool make(std::uint32_t piece, Fragment& fragment) const {
        fragment.seed = m_partition.seedOfPiece[piece];
        fragment.piece = m_places[piece].index;
        fragment.piecesOfSeed = m_places[piece].piecesOfSeed;
        fragment.depth = m_depth;
        fragment.outline = pieceOutline(m_partition, piece);
        fragment.mass = massOfPrism(fragment.outline, m_depth);
        const double around = addNeighbours(piece, fragment);
        if (!(widthOf(fragment.mass.volume / m_depth, around) > m_tolerance.thinnest)) return false;
        if (!m_gifts.empty()) addGifts(piece, fragment);
        sortByFragmentAndJoin(m_leastEdge, m_depth, fragment.bonds);
        moveToCentre(fragment);
        std::optional<IndexLoops> parts = hullParts(fragment.outline, m_tolerance);
        if (!parts) return false;
        fragment.parts = std::move(*parts);
        return true;
    }

    /// Calls visit(fragment behind it, length) for every edge of a ring.
    template <class Visit>
    void forEachEdge(std::uint32_t ring, Visit visit) const {
        const std::uint32_t begin = m_partition.cornersOfRing[ring], end = m_partition.cornersOfRing[ring + 1];
        Vec2 from = m_partition.points[m_partition.corners[begin]];
        for (std::uint32_t corner = begin; corner < end; ++corner) {
            const Vec2 to = m_partition.points[m_partition.corners[corner + 1 < end ? corner + 1 : begin]];
            const std::uint32_t across = m_partition.across[corner];
            visit(across == kNone ? kNone : m_places[across].fragment, glm::distance(from, to));
            from = to;
        }
    }

    /// Who is behind each edge, and a bond for each edge to another fragment, with the edge's length in place of its
    /// area. Gives the length of all edges.
    double addNeighbours(std::uint32_t piece, Fragment& fragment) const {
        const std::uint32_t first = m_partition.ringsOfPiece[piece], end = m_partition.ringsOfPiece[piece + 1];
        const std::uint32_t self = m_places[piece].fragment;
        double around = 0.0;
        const std::size_t edges = m_partition.cornersOfRing[end] - m_partition.cornersOfRing[first];
        fragment.across.reserve(edges);
        fragment.bonds.reserve(edges);
        for (std::uint32_t ring = first; ring < end; ++ring) {
            forEachEdge(ring, [&](std::uint32_t behind, double length) {
                around += length;
                fragment.across.push_back(behind);
                if (behind != kNone && behind != self) fragment.bonds.push_back({behind, length});
            });
        }
        return around;
    }

    /// The mass and the neighbours of the thin pieces that a piece receives.
    void addGifts(std::uint32_t piece, Fragment& fragment) const {
        const std::uint32_t self = m_places[piece].fragment;
        std::vector<MassProperties> masses{fragment.mass};
        for (const ThinPieceGift& gift : m_gifts) {
            if (gift.receiver != piece) continue;
            masses.push_back(massOfPrism(pieceOutline(m_partition, gift.thin), m_depth));
            for (std::uint32_t ring = m_partition.ringsOfPiece[gift.thin];
                 ring < m_partition.ringsOfPiece[gift.thin + 1]; ++ring) {
                forEachEdge(ring, [&](std::uint32_t behind, double length) {
                    if (behind != kNone && behind != self) fragment.bonds.push_back({behind, length});
                });
            }
        }
        if (masses.size() > 1) fragment.mass = combined(masses);
    }

    void moveToCentre(Fragment& fragment) const {
        const Vec2 centre{fragment.mass.centre};
        fragment.offset = Vec3{m_partition.origin + centre, 0.0};
        fragment.mass.centre = Vec3{0.0, 0.0, 0.0};
        for (Vec2& corner : fragment.outline.outer) corner -= centre;
        for (Ring& hole : fragment.outline.holes) {
            for (Vec2& corner : hole) corner -= centre;
        }
    }

    const Partition& m_partition;
    double m_depth;
    HullTolerance m_tolerance;
    double m_leastEdge = 0.0;            // m
    std::vector<Place> m_places;         // one a piece
    std::vector<ThinPieceGift> m_gifts;  // one a thin piece, by seed, then piece
    std::vector<Fragment> m_fragments;
};

void addHull(std::span<const Vec2> ring, double depth, std::vector<Polytope>& hulls) {
    Polytope hull = extruded(ring, -depth / 2.0, depth / 2.0);
    if (!hull.vertices.empty()) hulls.push_back(std::move(hull));
}

}  // namespace

std::vector<Polytope> hullsOf(const Fragment& fragment) {
    std::vector<Polytope> hulls;
    if (fragment.parts.empty()) {
        addHull(fragment.outline.outer, fragment.depth, hulls);
        return hulls;
    }
    const std::vector<Vec2> corners = numberedCorners(fragment.outline).points;
    for (const std::vector<std::uint32_t>& part : fragment.parts) {
        Ring ring;
        for (const std::uint32_t corner : part) ring.push_back(corners[corner]);
        addHull(ring, fragment.depth, hulls);
    }
    return hulls;
}

Result<Fragments> extrudedFragments(const Prism& prism, const Partition& partition, const TaskContext& task) {
    Extrusion extrusion(prism, partition);
    if (!extrusion.run(task)) return TaskContext::cancelled();
    return extrusion.result();
}

}  // namespace rubble
