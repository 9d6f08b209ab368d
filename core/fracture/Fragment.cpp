#include "core/fracture/Fragment.h"

#include "core/base/Parallel.h"
#include "core/fracture/PieceHulls.h"
#include "core/fracture/ThinPieces.h"
#include "core/fracture/VoronoiPartition.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <atomic>

namespace rubble {
namespace {

constexpr std::size_t kBlock = 128;  // fragments that a thread makes between two looks at the cancel token
constexpr double kThinnest = 1e-9;   // of the outline's width
constexpr double kFlat = 1e-12;      // of the outline's diameter: far above the rounding of constructed points

/// A piece of the partition among those of its seed.
struct PieceOfSeed {
    std::uint32_t piece = 0;
    std::uint32_t index = 0;
    std::uint32_t count = 1;
};

/// All pieces, by seed, then by index.
std::vector<PieceOfSeed> piecesBySeed(const Partition& partition) {
    std::vector<PieceOfSeed> pieces;
    if (partition.pieceOfSeed.empty()) pieces.resize(partition.pieceCount());  // the outline, unbroken
    pieces.reserve(partition.pieceCount());
    for (const std::uint32_t first : partition.pieceOfSeed) {
        if (first == kNone) continue;
        std::uint32_t end = first + 1;
        while (end < partition.pieceCount() && partition.seedOfPiece[end] == partition.seedOfPiece[first]) ++end;
        for (std::uint32_t piece = first; piece < end; ++piece) {
            pieces.push_back({piece, piece - first, end - first});
        }
    }
    return pieces;
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
        : m_partition(partition), m_depth(prism.depth), m_pieces(piecesBySeed(partition)) {
        const double diameter = boundsOf(prism.outline.outer).diagonal();
        double around = perimeter(prism.outline.outer);
        for (const Ring& hole : prism.outline.holes) around += perimeter(hole);
        m_tolerance = {kThinnest * widthOf(area(prism.outline), around), kFlat * diameter};
        m_leastEdge = kLeastSharedEdge * diameter;
        nameFragments();
    }

    /// Makes one fragment a piece, but for thin ones. Makes all again when a thin piece is found, as its neighbours
    /// change. False where the task was cancelled.
    bool run(const TaskContext& task) {
        while (true) {
            m_fragments.clear();
            m_fragments.resize(m_pieces.size());
            std::vector<std::uint8_t> isThin(m_pieces.size());
            forEachIndex((m_pieces.size() + kBlock - 1) / kBlock, task.threads, [&](std::size_t block) {
                if (task.isCancelled()) return;
                const std::size_t end = std::min(m_pieces.size(), (block + 1) * kBlock);
                for (std::size_t i = block * kBlock; i < end; ++i) isThin[i] = !make(m_pieces[i], m_fragments[i]);
            });
            if (task.isCancelled()) return false;
            if (std::ranges::count(isThin, 1) == 0) return true;
            takeOut(isThin);
        }
    }

    Fragments result() {
        Fragments result{std::move(m_fragments), m_partition.reports};
        for (const ThinPieceGift& gift : m_gifts) {
            const Polygon outline = pieceOutline(m_partition, gift.thin);
            double around = perimeter(outline.outer);
            for (const Ring& hole : outline.holes) around += perimeter(hole);
            const double size = area(outline);
            result.reports.push_back(thinPieceReport(m_partition, gift, size, widthOf(size, around)));
        }
        return result;
    }

private:
    void nameFragments() {
        m_fragmentOf.assign(m_partition.pieceCount(), kNone);
        for (std::uint32_t i = 0; i < m_pieces.size(); ++i) m_fragmentOf[m_pieces[i].piece] = i;
        for (const ThinPieceGift& gift : m_gifts) {
            if (gift.receiver != kNone) m_fragmentOf[gift.thin] = m_fragmentOf[gift.receiver];
        }
    }

    void takeOut(const std::vector<std::uint8_t>& isThin) {
        std::vector<PieceOfSeed> kept;
        for (std::size_t i = 0; i < m_pieces.size(); ++i) {
            if (isThin[i])
                m_thin.push_back(m_pieces[i].piece);
            else
                kept.push_back(m_pieces[i]);
        }
        m_pieces = std::move(kept);
        m_gifts = thinPieceGifts(m_partition, m_thin);
        nameFragments();
    }

    /// False where the piece is too thin.
    bool make(const PieceOfSeed& from, Fragment& fragment) const {
        fragment.seed = m_partition.seedOfPiece[from.piece];
        fragment.piece = from.index;
        fragment.piecesOfSeed = from.count;
        fragment.depth = m_depth;
        fragment.outline = pieceOutline(m_partition, from.piece);
        fragment.mass = massOfPrism(fragment.outline, m_depth);
        const double around = addNeighbours(from.piece, fragment);
        if (!(widthOf(fragment.mass.volume / m_depth, around) > m_tolerance.thinnest)) return false;
        if (!m_gifts.empty()) addGifts(from.piece, fragment);
        sortByFragmentAndJoin(m_leastEdge, m_depth, fragment.bonds);
        moveToCentre(fragment);
        fragment.hulls = hullsOfPiece(fragment.outline, m_depth, m_tolerance);
        return !fragment.hulls.empty();
    }

    /// Calls visit(fragment behind it, length) for every edge of a ring.
    template <class Visit>
    void forEachEdge(std::uint32_t ring, Visit visit) const {
        const std::uint32_t begin = m_partition.cornersOfRing[ring], end = m_partition.cornersOfRing[ring + 1];
        Vec2 from = m_partition.points[m_partition.corners[begin]];
        for (std::uint32_t corner = begin; corner < end; ++corner) {
            const Vec2 to = m_partition.points[m_partition.corners[corner + 1 < end ? corner + 1 : begin]];
            const std::uint32_t across = m_partition.across[corner];
            visit(across == kNone ? kNone : m_fragmentOf[across], glm::distance(from, to));
            from = to;
        }
    }

    /// Who is behind each edge, and a bond for each edge to another fragment, with the edge's length in place of its
    /// area. Gives the length of all edges.
    double addNeighbours(std::uint32_t piece, Fragment& fragment) const {
        const std::uint32_t first = m_partition.ringsOfPiece[piece], end = m_partition.ringsOfPiece[piece + 1];
        const std::uint32_t self = m_fragmentOf[piece];
        double around = 0.0;
        fragment.across.resize(end - first);
        fragment.bonds.reserve(m_partition.cornersOfRing[end] - m_partition.cornersOfRing[first]);
        for (std::uint32_t ring = first; ring < end; ++ring) {
            std::vector<std::uint32_t>& across = fragment.across[ring - first];
            across.reserve(m_partition.ringCorners(ring).size());
            forEachEdge(ring, [&](std::uint32_t behind, double length) {
                around += length;
                across.push_back(behind);
                if (behind != kNone && behind != self) fragment.bonds.push_back({behind, length});
            });
        }
        return around;
    }

    /// The mass and the neighbours of the thin pieces that a piece receives.
    void addGifts(std::uint32_t piece, Fragment& fragment) const {
        const std::uint32_t self = m_fragmentOf[piece];
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
    double m_leastEdge = 0.0;                 // m
    std::vector<PieceOfSeed> m_pieces;        // one a fragment
    std::vector<std::uint32_t> m_fragmentOf;  // of each piece; of the receiver for a thin one
    std::vector<std::uint32_t> m_thin;        // by seed, then piece, of those that each round found
    std::vector<ThinPieceGift> m_gifts;       // one a thin piece
    std::vector<Fragment> m_fragments;
};

}  // namespace

Result<Fragments> extrudedFragments(const Prism& prism, const Partition& partition, const TaskContext& task) {
    Extrusion extrusion(prism, partition);
    if (!extrusion.run(task)) return TaskContext::cancelled();
    return extrusion.result();
}

}  // namespace rubble
