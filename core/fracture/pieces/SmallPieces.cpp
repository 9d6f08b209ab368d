#include "core/fracture/pieces/SmallPieces.h"

#include "core/base/QuantityText.h"
#include "core/fracture/partition/CappedDiagnostics.h"
#include "core/fracture/pieces/PieceDraft.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <queue>

namespace rubble {
namespace {

double sumOf(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

/// Disjoint groups of pieces to be merged, each with its receiver and area.
class Groups {
public:
    Groups(const Partition& partition, std::vector<double> areas)
        : m_partition(partition), m_areas(std::move(areas)), m_members(m_areas.size()), m_receivers(m_areas.size()) {
        std::iota(m_receivers.begin(), m_receivers.end(), 0u);
        for (std::uint32_t piece = 0; piece < m_members.size(); ++piece) m_members[piece] = {piece};
    }

    bool isReceiver(std::uint32_t piece) const { return m_receivers[piece] == piece; }
    double area(std::uint32_t receiver) const { return m_areas[receiver]; }
    const std::vector<std::uint32_t>& receivers() const { return m_receivers; }

    /// The group along the longest shared edge; kNone where there is no other.
    std::uint32_t neighbourOf(std::uint32_t receiver) const {
        std::map<std::uint32_t, double> lengths;
        for (const std::uint32_t member : m_members[receiver]) {
            for (const PieceContact& contact : contactsOf(m_partition, member, 0.0)) {
                if (m_receivers[contact.piece] != receiver) lengths[m_receivers[contact.piece]] += contact.length;
            }
        }
        const auto isShorter = [](const auto& a, const auto& b) { return a.second < b.second; };
        const auto longest = std::ranges::max_element(lengths, isShorter);
        return longest == lengths.end() ? kNone : longest->first;
    }

    void merge(std::uint32_t piece, std::uint32_t receiver) {
        for (const std::uint32_t member : m_members[piece]) {
            m_receivers[member] = receiver;
            m_members[receiver].push_back(member);
        }
        m_members[piece].clear();
        m_areas[receiver] += m_areas[piece];
    }

private:
    const Partition& m_partition;
    std::vector<double> m_areas;                        // this and the next: of receivers
    std::vector<std::vector<std::uint32_t>> m_members;  // including the receiver
    std::vector<std::uint32_t> m_receivers;             // of each piece
};

Diagnostic mergedReport(const Partition& partition, std::uint32_t piece, std::uint32_t receiver, double area) {
    const std::uint32_t seed = partition.seedOfPiece[piece], of = partition.seedOfPiece[receiver];
    if (seed == kNone) {
        return diagnostic(
            DiagnosticCode::MergedPiece, {},
            "A piece of " + quantityText(QuantityKind::Area, area) + " is too small; it is merged into a neighbour.",
            area);
    }
    const bool isPart = partOfCell(partition, piece) != kNone;
    return diagnostic(DiagnosticCode::MergedPiece, {.seed = seed, .otherSeed = of},
                      std::string(isPart ? "Part of the" : "The") + " cell of seed " + std::to_string(seed) +
                          " is too small (" + quantityText(QuantityKind::Area, area) +
                          "); it is merged into the cell of seed " + std::to_string(of) + ".",
                      area);
}

}  // namespace

double minPieceArea(const SmallPieces& small, double area, std::uint32_t count, double depth) {
    if (small.rule == SmallPieceRule::Keep) return 0.0;
    switch (small.measure) {
        case PieceMeasure::Area: return small.limit;
        case PieceMeasure::Volume: return small.limit / depth;
        case PieceMeasure::FractionOfMean: return small.limit * area / count;
        case PieceMeasure::FractionOfWhole: return small.limit * area;
    }
    return 0.0;
}

Partition withoutSmallPieces(Partition partition, const SmallPieces& small, double depth) {
    const std::vector<double> areas = pieceAreas(partition);
    const double whole = sumOf(areas);
    std::uint32_t count = partition.pieceCount();
    using Entry = std::pair<double, std::uint32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> waiting;
    for (std::uint32_t piece = 0; piece < count; ++piece) waiting.push({areas[piece], piece});
    Groups groups(partition, areas);
    while (waiting.top().first < minPieceArea(small, whole, count, depth) && count > 1) {
        const auto [area, piece] = waiting.top();
        waiting.pop();
        if (!groups.isReceiver(piece) || groups.area(piece) != area) continue;  // merged, or grown since
        const std::uint32_t receiver = groups.neighbourOf(piece);
        if (receiver == kNone) break;
        groups.merge(piece, receiver);
        waiting.push({groups.area(receiver), receiver});
        --count;
    }
    if (count == partition.pieceCount()) return partition;

    CappedDiagnostics merges;
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
        if (groups.isReceiver(piece)) continue;
        merges.add(DiagnosticCode::MergedPiece,
                   [&] { return mergedReport(partition, piece, groups.receivers()[piece], areas[piece]); });
    }
    std::vector<Diagnostic> reports = std::move(merges).list();
    std::ranges::stable_sort(reports, {}, [](const Diagnostic& diagnostic) { return diagnostic.place.seed; });
    PieceDraft draft(std::move(partition));
    draft.merge(groups.receivers());
    Partition merged = std::move(draft).finished();
    merged.diagnostics.insert(merged.diagnostics.end(), reports.begin(), reports.end());
    return merged;
}

std::vector<std::uint32_t> seedsToDrop(const Partition& partition, const SmallPieces& small, double depth) {
    std::vector<double> cells(partition.pieceOfSeed.size());
    const std::vector<double> areas = pieceAreas(partition);
    for (std::uint32_t piece = 0; piece < areas.size(); ++piece) {
        if (partition.seedOfPiece[piece] != kNone) cells[partition.seedOfPiece[piece]] += areas[piece];
    }
    const auto count = static_cast<std::uint32_t>(std::ranges::count_if(cells, [](double area) { return area > 0.0; }));
    const double least = count > 1 ? minPieceArea(small, sumOf(areas), count, depth) : 0.0;
    std::vector<bool> isKept(cells.size());
    for (std::uint32_t seed = 0; seed < cells.size(); ++seed) isKept[seed] = cells[seed] >= least || cells[seed] == 0.0;
    for (std::uint32_t piece = 0; piece < areas.size(); ++piece) {
        const std::uint32_t seed = partition.seedOfPiece[piece];
        if (seed == kNone || cells[seed] >= least) continue;
        for (const PieceContact& contact : contactsOf(partition, piece, 0.0)) {
            const std::uint32_t other = partition.seedOfPiece[contact.piece];
            if (std::pair(cells[other], other) < std::pair(cells[seed], seed)) isKept[seed] = true;
        }
    }
    std::vector<std::uint32_t> dropped;
    for (std::uint32_t seed = 0; seed < cells.size(); ++seed) {
        if (!isKept[seed]) dropped.push_back(seed);
    }
    return dropped;
}

}  // namespace rubble
