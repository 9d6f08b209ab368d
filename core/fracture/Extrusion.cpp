#include "core/base/MessageText.h"
#include "core/base/Parallel.h"
#include "core/fracture/Fragment.h"
#include "core/fracture/LeftTurns.h"
#include "core/fracture/PieceShrinking.h"
#include "core/fracture/VoronoiPartition.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <atomic>

namespace rubble {
namespace {

constexpr std::size_t kBlock = 512;  // fragments that a thread makes between two looks at the cancel token
constexpr double kThinnest = 1e-9;   // of the outline's width
constexpr double kFlat = 1e-12;      // of the outline's diameter: far above the rounding of constructed points

/// Puts a piece's outline where another one was: its memory is used again.
void takeOutline(const Partition& partition, std::uint32_t piece, Polygon& outline) {
    const std::uint32_t ring = partition.ringsOfPiece[piece];
    if (partition.ringsOfPiece[piece + 1] - ring > 1) {
        outline = pieceOutline(partition, piece);
        return;
    }
    const std::span<const std::uint32_t> corners = partition.ringCorners(ring);
    outline.holes.clear();
    outline.outer.resize(corners.size());
    for (std::size_t i = 0; i < corners.size(); ++i) outline.outer[i] = partition.points[corners[i]];
}

void moveToCentre(Vec2 centre, Polygon& outline) {
    for (Vec2& corner : outline.outer) corner -= centre;
    for (Ring& hole : outline.holes) {
        for (Vec2& corner : hole) corner -= centre;
    }
}

/// Makes fragments from pieces, of which some may have been found too thin to become one.
class Extrusion {
public:
    Extrusion(const Prism& prism, Partition&& partition, Partition&& shrunk) : m_isThin(partition.pieceCount(), 0) {
        const double diameter = boundsOf(prism.outline.outer).diagonal();
        m_all.depth = prism.depth;
        m_all.tolerance = {kThinnest * widthOf(prism.outline), kFlat * diameter};
        m_all.leastEdge = kLeastSharedEdge * diameter;
        m_all.records.resize(m_isThin.size());
        m_all.partition = std::move(partition);
        m_all.shrunk = std::move(shrunk);
        for (std::uint32_t piece = 0; piece < m_isThin.size() && hasGap(); ++piece) {
            m_isThin[piece] = m_all.shrunk.ringsOfPiece[piece] == m_all.shrunk.ringsOfPiece[piece + 1];
        }
    }

    /// Makes one fragment a piece, but for thin ones. Makes all again when thin pieces are found, as their receivers
    /// change. False where the task was cancelled.
    bool run(const TaskContext& task) {
        while (true) {
            numberFragments();
            std::atomic<bool> isAnyThin = false;
            forEachIndex((m_isThin.size() + kBlock - 1) / kBlock, task.threads, [&](std::size_t block) {
                if (task.isCancelled()) return;
                if (!makeBlock(block * kBlock)) isAnyThin = true;
            });
            if (task.isCancelled()) return false;
            if (!isAnyThin) return true;
            if (!hasGap()) giveAwayThinPieces();
        }
    }

    Fragments result() && {
        m_all.reports = std::move(m_all.partition.reports);
        if (hasGap()) reportGap();
        for (const ThinPieceGift& gift : m_all.gifts) m_all.reports.push_back(thinPieceReport(m_all.partition, gift));
        for (std::uint32_t fragment = 0; fragment < m_all.count() && !m_all.gifts.empty(); ++fragment) {
            const std::uint32_t piece = m_all.pieceOfFragment[fragment];
            if (!m_all.records[piece].hasGifts) continue;
            m_all.giftedMasses.push_back({fragment, massWithGifts(piece)});
            m_all.giftedMasses.back().mass.centre = Vec3{0.0, 0.0, 0.0};
        }
        return std::move(m_all);
    }

private:
    bool hasGap() const { return &m_all.shapes() != &m_all.partition; }

    /// Says what the gap took, and from whom all.
    void reportGap() {
        m_all.reports.insert(m_all.reports.end(), m_all.shrunk.reports.begin(), m_all.shrunk.reports.end());
        for (std::uint32_t piece = 0; piece < m_isThin.size(); ++piece) {
            const double whole = pieceArea(m_all.partition, piece);
            m_all.gapArea += whole - (m_isThin[piece] ? 0.0 : m_all.records[piece].moments.area);
            if (!m_isThin[piece] || m_all.shrunk.ringsOfPiece[piece] == m_all.shrunk.ringsOfPiece[piece + 1]) continue;
            m_all.reports.push_back(vanishedReport(m_all.partition, piece, whole));
        }
        m_all.reports.push_back(
            {ReportCode::Gap, kNone, kNone, m_all.gapArea,
             "The gap between pieces takes " + messageText(m_all.gapArea * m_all.depth) + " m^3 from them."});
    }

    /// Numbers fragments by seed, then by piece, with none for thin pieces, which have the number of their receiver.
    void numberFragments() {
        const Partition& partition = m_all.partition;
        m_all.fragmentOfPiece.assign(m_isThin.size(), kNone);
        m_all.pieceOfFragment.resize(m_isThin.size());
        std::uint32_t count = 0;
        const auto number = [&](std::uint32_t first) {
            for (std::uint32_t piece = first;
                 piece < m_isThin.size() && partition.seedOfPiece[piece] == partition.seedOfPiece[first]; ++piece) {
                if (m_isThin[piece]) continue;
                m_all.fragmentOfPiece[piece] = count;
                m_all.pieceOfFragment[count++] = piece;
            }
        };
        for (const std::uint32_t first : partition.pieceOfSeed) {
            if (first != kNone) number(first);
        }
        if (partition.pieceOfSeed.empty()) number(0);  // the outline, unbroken
        for (const ThinPieceGift& gift : m_all.gifts) {
            if (gift.receiver != kNone) m_all.fragmentOfPiece[gift.thin] = m_all.fragmentOfPiece[gift.receiver];
        }
        m_all.pieceOfFragment.resize(count);
    }

    /// Makes the fragments of a block of pieces, as they stand in memory. False where one was found to be thin.
    bool makeBlock(std::size_t begin) {
        const auto end = static_cast<std::uint32_t>(std::min(m_isThin.size(), begin + kBlock));
        bool isAnyThin = false;
        Polygon outline;
        for (auto piece = static_cast<std::uint32_t>(begin); piece < end; ++piece) {
            if (m_isThin[piece] || make(piece, outline)) continue;
            m_isThin[piece] = isAnyThin = true;
        }
        return !isAnyThin;
    }

    void giveAwayThinPieces() {
        std::vector<std::uint32_t> thin;
        for (std::uint32_t piece = 0; piece < m_isThin.size(); ++piece) {
            if (m_isThin[piece]) thin.push_back(piece);
        }
        std::ranges::stable_sort(thin, {}, [&](std::uint32_t piece) { return m_all.partition.seedOfPiece[piece]; });
        m_all.gifts = thinPieceGifts(m_all.partition, thin);
    }

    /// False where the piece is too thin. `outline` is room to work in.
    bool make(std::uint32_t piece, Polygon& outline) {
        takeOutline(m_all.shapes(), piece, outline);
        PieceRecord& record = m_all.records[piece];
        record.moments = momentsOf(outline);
        if (!isWider(outline, record.moments.area, m_all.tolerance.thinnest)) return false;
        const auto isGift = [&](const ThinPieceGift& gift) { return gift.receiver == piece; };
        record.hasGifts = std::ranges::any_of(m_all.gifts, isGift);
        if (record.hasGifts) record.moments.centre = Vec2{massWithGifts(piece).centre};
        moveToCentre(record.moments.centre, outline);
        record.isConvex = outline.holes.empty() && turnsLeft(outline.outer);
        if (record.isConvex) return true;
        const std::optional<IndexLoops> parts = hullParts(outline, m_all.tolerance);
        record.isConvex = parts && parts->empty();
        return parts.has_value();
    }

    /// The mass of a piece and of the thin ones that it receives.
    MassProperties massWithGifts(std::uint32_t piece) const {
        std::vector<MassProperties> masses{massOfPrism(pieceOutline(m_all.partition, piece), m_all.depth)};
        for (const ThinPieceGift& gift : m_all.gifts) {
            if (gift.receiver != piece) continue;
            masses.push_back(massOfPrism(pieceOutline(m_all.partition, gift.thin), m_all.depth));
        }
        return combined(masses);
    }

    Fragments m_all;
    std::vector<std::uint8_t> m_isThin;  // of each piece; not bits, as threads write to neighbours
};

}  // namespace

Result<Fragments> extrudedFragments(const Prism& prism, Partition partition, const TaskContext& task) {
    return extrudedFragments(prism, std::move(partition), 0.0, task);
}

Result<Fragments> extrudedFragments(const Prism& prism, Partition partition, double gap, const TaskContext& task) {
    Result<Partition> shrunk = gap > 0.0 ? shrunkPartition(partition, gap / 2.0, task) : Partition{};
    if (!shrunk) return shrunk.error();
    Extrusion extrusion(prism, std::move(partition), std::move(*shrunk));
    if (!extrusion.run(task)) return TaskContext::cancelled();
    return std::move(extrusion).result();
}

}  // namespace rubble
