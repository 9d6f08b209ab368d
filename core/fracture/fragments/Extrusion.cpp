#include "core/fracture/fragments/Extrusion.h"

#include "core/base/Parallel.h"
#include "core/base/QuantityText.h"
#include "core/fracture/partition/CappedDiagnostics.h"
#include "core/fracture/pieces/PieceGap.h"
#include "core/fracture/pieces/PieceWidth.h"
#include "core/fracture/pieces/StrictConvexity.h"
#include "core/fracture/voronoi/VoronoiPartition.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <atomic>

namespace rubble {
namespace {

constexpr std::size_t kBlock = 512;  // fragments between two cancellation checks
constexpr double kMinWidth = 1e-9;   // of the outline's width
constexpr double kFlatness = 1e-12;  // of the outline's diameter: far above the rounding of constructed points

/// Like pieceOutline(), but reuses the memory of `outline`.
void setOutline(const Partition& partition, std::uint32_t piece, Polygon& outline) {
    if (partition.ringCount(piece) > 1) {
        outline = pieceOutline(partition, piece);
        return;
    }
    const std::span<const std::uint32_t> corners = partition.ringCorners(partition.outerRing(piece));
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

/// Makes a fragment from each piece that is not too thin.
class Extrusion {
public:
    Extrusion(const Prism& prism, Partition&& partition, double gap, std::shared_ptr<const Partition> shrunk)
        : m_isThin(partition.pieceCount(), 0) {
        const double diameter = boundsOf(prism.outline.outer).diagonal();
        m_all.depth = prism.depth;
        m_gap = gap;
        m_all.tolerance = {kMinWidth * widthOf(prism.outline), kFlatness * diameter};
        m_all.minSharedEdge = kMinSharedEdge * diameter;
        m_all.records.resize(m_isThin.size());
        m_all.partition = std::move(partition);
        m_all.shrunk = std::move(shrunk);
        for (std::uint32_t piece = 0; piece < m_isThin.size() && hasGap(); ++piece) {
            m_isThin[piece] = m_all.shrunk->isEmpty(piece);
        }
    }

    /// Makes the fragments. Starts again when thin pieces are found, because their receivers change. False if
    /// cancelled.
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
            if (!hasGap()) transferThinPieces();
        }
    }

    Fragments result() && {
        m_diagnostics = std::move(m_all.partition.diagnostics);
        if (hasGap()) reportGap();
        CappedDiagnostics transfers;
        for (const MassTransfer& transfer : m_all.massTransfers) {
            transfers.add(DiagnosticCode::ThinPiece, [&] { return massTransferReport(m_all.partition, transfer); });
        }
        std::ranges::move(std::move(transfers).list(), std::back_inserter(m_diagnostics));
        for (std::uint32_t fragment = 0; fragment < m_all.pieceOfFragment.size() && !m_all.massTransfers.empty();
             ++fragment) {
            const std::uint32_t piece = m_all.pieceOfFragment[fragment];
            if (!m_all.records[piece].receivesMass) continue;
            m_all.adjustedMasses.push_back({fragment, massWithTransfers(piece)});
            m_all.adjustedMasses.back().mass.centre = Vec3{0.0, 0.0, 0.0};
        }
        return {.parts = std::move(m_all), .gap = m_gap, .diagnostics = std::move(m_diagnostics)};
    }

private:
    bool hasGap() const { return m_all.shrunk != nullptr; }

    /// Reports the area that the gap removed, and the pieces that vanished.
    void reportGap() {
        m_diagnostics.insert(m_diagnostics.end(), m_all.shrunk->diagnostics.begin(), m_all.shrunk->diagnostics.end());
        CappedDiagnostics vanished;
        for (std::uint32_t piece = 0; piece < m_isThin.size(); ++piece) {
            const double whole = pieceArea(m_all.partition, piece);
            m_all.gapArea += whole - (m_isThin[piece] ? 0.0 : m_all.records[piece].moments.area);
            if (!m_isThin[piece] || m_all.shrunk->isEmpty(piece)) continue;
            vanished.add(DiagnosticCode::VanishedPiece, [&] { return vanishedReport(m_all.partition, piece, whole); });
        }
        std::ranges::move(std::move(vanished).list(), std::back_inserter(m_diagnostics));
        m_diagnostics.push_back(diagnostic(DiagnosticCode::Gap, {},
                                           "The gap between fragments takes " +
                                               quantityText(QuantityKind::Volume, m_all.gapArea * m_all.depth) +
                                               " from them.",
                                           m_all.gapArea));
    }

    /// Numbers fragments by seed, then by piece; thin pieces get the number of their receiver.
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
        if (partition.pieceOfSeed.empty()) number(0);  // the whole outline
        for (const MassTransfer& transfer : m_all.massTransfers) {
            if (transfer.receiver != kNone)
                m_all.fragmentOfPiece[transfer.thin] = m_all.fragmentOfPiece[transfer.receiver];
        }
        m_all.pieceOfFragment.resize(count);
    }

    /// Makes the fragments of a block of pieces. False if one of them is too thin.
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

    void transferThinPieces() {
        std::vector<std::uint32_t> thin;
        for (std::uint32_t piece = 0; piece < m_isThin.size(); ++piece) {
            if (m_isThin[piece]) thin.push_back(piece);
        }
        std::ranges::stable_sort(thin, {}, [&](std::uint32_t piece) { return m_all.partition.seedOfPiece[piece]; });
        m_all.massTransfers = massTransfersOf(m_all.partition, thin);
        m_isReceiver.assign(m_isThin.size(), 0);
        for (const MassTransfer& transfer : m_all.massTransfers) {
            if (transfer.receiver != kNone) m_isReceiver[transfer.receiver] = 1;
        }
    }

    /// False if the piece is too thin. `outline` is scratch memory.
    bool make(std::uint32_t piece, Polygon& outline) {
        setOutline(m_all.shapes(), piece, outline);
        PieceRecord& record = m_all.records[piece];
        record.moments = momentsOf(outline);
        if (!isWider(outline, record.moments.area, m_all.tolerance.minWidth)) return false;
        record.receivesMass = !m_isReceiver.empty() && m_isReceiver[piece];
        if (record.receivesMass) record.moments.centre = Vec2{massWithTransfers(piece).centre};
        moveToCentre(record.moments.centre, outline);
        record.isConvex = outline.holes.empty() && isStrictlyConvex(outline.outer);
        if (record.isConvex) return true;
        const std::optional<IndexLoops> parts = hullParts(outline, m_all.tolerance);
        record.isConvex = parts && parts->empty();
        return parts.has_value();
    }

    /// The mass of a piece and of the thin pieces that are transferred to it.
    MassProperties massWithTransfers(std::uint32_t piece) const {
        std::vector<MassProperties> masses{massOfPrism(pieceOutline(m_all.partition, piece), m_all.depth)};
        for (const MassTransfer& transfer : m_all.massTransfers) {
            if (transfer.receiver != piece) continue;
            masses.push_back(massOfPrism(pieceOutline(m_all.partition, transfer.thin), m_all.depth));
        }
        return combined(masses);
    }

    ExtrudedPieces m_all;
    double m_gap = 0.0;  // m
    std::vector<Diagnostic> m_diagnostics;
    std::vector<std::uint8_t> m_isThin;  // of each piece; not vector<bool>, because threads write to it concurrently
    std::vector<std::uint8_t> m_isReceiver;  // of each piece, whether it receives mass; empty: none does
};

}  // namespace

Result<Fragments> extrudedFragments(const Prism& prism, Partition partition, const TaskContext& task) {
    return extrudedFragments(prism, std::move(partition), 0.0, task);
}

Result<Fragments> extrudedFragments(const Prism& prism, Partition partition, double gap, const TaskContext& task) {
    std::shared_ptr<const Partition> shrunk;
    if (gap > 0.0) {
        Result<Partition> pieces = shrunkPartition(partition, gap / 2.0, task);
        if (!pieces) return pieces.error();
        shrunk = std::make_shared<const Partition>(std::move(*pieces));
    }
    Extrusion extrusion(prism, std::move(partition), gap, std::move(shrunk));
    if (!extrusion.run(task)) return TaskContext::cancelled();
    return std::move(extrusion).result();
}

}  // namespace rubble
