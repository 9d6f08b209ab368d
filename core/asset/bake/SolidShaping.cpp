#include "core/asset/bake/SolidShaping.h"

#include "core/base/QuantityText.h"
#include "core/fracture/partition/CappedDiagnostics.h"
#include "core/fracture/solid/SolidContacts.h"
#include "core/fracture/solid/SolidMerge.h"

#include <algorithm>
#include <numeric>
#include <unordered_map>

namespace rubble {
namespace {

std::string nameOf(const SolidPartition& partition, std::uint32_t fragment, const Seeds& seeds) {
    const std::uint32_t part = partition.partOfFragment[fragment];
    const SeedId id = seeds.ids.empty() ? SeedId{} : seeds.ids[partition.seedOfFragment[fragment]];
    return id.text() + (part == kNone ? "" : "." + std::to_string(part));
}

/// Applies edits to the fragments of one fracture: all merges together, since numbers change with each.
class SolidEditor {
public:
    SolidEditor(const SolidPartition& partition, const Seeds& seeds)
        : m_contacts(contactsOf(partition)), m_receivers(partition.fragmentCount()) {
        std::iota(m_receivers.begin(), m_receivers.end(), 0u);
        for (std::uint32_t k = 0; k < m_receivers.size(); ++k) m_fragments[nameOf(partition, k, seeds)] = k;
    }

    void apply(const FragmentMerge& merge) {
        const std::uint32_t into = find(merge.into);
        if (into == kNone) return reportLost(merge.into, "does not exist; nothing is merged into it.");
        std::vector<std::uint32_t> pending;
        for (const FragmentPath& path : merge.merged) {
            const std::uint32_t fragment = find(path);
            if (fragment == kNone) {
                reportLost(path, "does not exist; it is not merged into " + merge.into + ".");
            } else if (fragment != into) {
                pending.push_back(fragment);
            }
        }
        mergeTouching(into, pending);
        for (const FragmentPath& path : merge.merged) {
            const std::uint32_t fragment = find(path);
            if (fragment != kNone && fragment != into)
                reportLost(path, "does not touch " + merge.into + "; they are not merged.");
        }
    }

    void apply(const FragmentSplit& split) {
        reportLost(split.fragment, "is one of a mesh, which is not split along a line.");
    }

    const std::vector<std::uint32_t>& receivers() const { return m_receivers; }
    std::vector<Diagnostic>& reports() { return m_reports; }

private:
    /// A fragment that is not merged into another; kNone: none has the name.
    std::uint32_t find(const FragmentPath& path) const {
        const auto found = m_fragments.find(path.substr(path.rfind('/') + 1));
        return found != m_fragments.end() && m_receivers[found->second] == found->second ? found->second : kNone;
    }

    bool areNeighbours(std::uint32_t first, std::uint32_t second) const {
        return std::ranges::any_of(m_contacts, [&](const SolidContact& contact) {
            const std::uint32_t one = m_receivers[contact.first], other = m_receivers[contact.second];
            return (one == first && other == second) || (one == second && other == first);
        });
    }

    /// Merges the fragments that are connected to `into`, directly or through each other.
    void mergeTouching(std::uint32_t into, std::vector<std::uint32_t> pending) {
        for (bool hasMerged = true; hasMerged;) {
            hasMerged = false;
            for (std::uint32_t& fragment : pending) {
                if (fragment == kNone || !areNeighbours(into, fragment)) continue;
                for (std::uint32_t& receiver : m_receivers) receiver = receiver == fragment ? into : receiver;
                fragment = kNone;
                hasMerged = true;
            }
        }
    }

    void reportLost(const FragmentPath& path, const std::string& rest) {
        m_reports.push_back(diagnostic(DiagnosticCode::LostPiece, {.path = path}, "Fragment " + path + " " + rest));
    }

    const std::vector<SolidContact> m_contacts;
    std::vector<std::uint32_t> m_receivers;
    std::unordered_map<std::string, std::uint32_t> m_fragments;  // by name
    std::vector<Diagnostic> m_reports;
};

Diagnostic mergedReport(const SolidPartition& partition, std::uint32_t fragment, const Seeds& seeds) {
    const double volume = partition.volumes[fragment];
    return diagnostic(DiagnosticCode::MergedPiece, {.seed = partition.seedOfFragment[fragment]},
                      "Fragment " + nameOf(partition, fragment, seeds) + " is too small (" +
                          quantityText(QuantityKind::Volume, volume) + "); it is merged into a neighbour.",
                      volume);
}

double sumOf(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

}  // namespace

SolidPartition editedFragments(SolidPartition partition, const Seeds& seeds, const std::vector<FragmentEdit>& edits,
                               const FragmentPath& parent, std::vector<Diagnostic>& diagnostics) {
    const auto isHere = [&](const FragmentEdit& edit) { return parentOf(edit) == parent; };
    if (std::ranges::none_of(edits, isHere)) return partition;
    SolidEditor editor(partition, seeds);
    for (const FragmentEdit& edit : edits) {
        if (isHere(edit)) std::visit([&](const auto& one) { editor.apply(one); }, edit);
    }
    std::ranges::move(editor.reports(), std::back_inserter(diagnostics));
    return mergedFragments(std::move(partition), editor.receivers());
}

double minFragmentVolume(const SmallPieces& small, double volume, std::uint32_t count) {
    if (small.rule == SmallPieceRule::Keep) return 0.0;
    switch (small.measure) {
        case PieceMeasure::Area: return 0.0;
        case PieceMeasure::Volume: return small.limit;
        case PieceMeasure::FractionOfMean: return small.limit * volume / count;
        case PieceMeasure::FractionOfWhole: return small.limit * volume;
    }
    return 0.0;
}

SolidPartition withoutSmallFragments(SolidPartition partition, const SmallPieces& small, const Seeds& seeds,
                                     std::vector<Diagnostic>& diagnostics) {
    CappedDiagnostics reports;
    while (true) {  // merging raises the mean
        const double least = minFragmentVolume(small, sumOf(partition.volumes), partition.fragmentCount());
        const SolidPartition before = partition;
        std::vector<std::uint32_t> merged;
        partition = withoutSmallFragments(std::move(partition), least, &merged);
        for (const std::uint32_t fragment : merged) {
            reports.add(DiagnosticCode::MergedPiece, [&] { return mergedReport(before, fragment, seeds); });
        }
        if (merged.empty()) break;
    }
    std::ranges::move(std::move(reports).list(), std::back_inserter(diagnostics));
    return partition;
}

std::vector<std::uint32_t> seedsToDrop(const SolidPartition& partition, const SmallPieces& small) {
    std::vector<double> cells(partition.fragmentOfSeed.size());
    for (std::uint32_t k = 0; k < partition.fragmentCount(); ++k)
        cells[partition.seedOfFragment[k]] += partition.volumes[k];
    const auto count =
        static_cast<std::uint32_t>(std::ranges::count_if(cells, [](double volume) { return volume > 0.0; }));
    const double least = count > 1 ? minFragmentVolume(small, sumOf(cells), count) : 0.0;
    std::vector<bool> isKept(cells.size());
    for (std::uint32_t seed = 0; seed < cells.size(); ++seed) isKept[seed] = cells[seed] >= least || cells[seed] == 0.0;
    for (const SolidContact& contact : contactsOf(partition)) {
        const std::uint32_t a = partition.seedOfFragment[contact.first], b = partition.seedOfFragment[contact.second];
        if (a != b) isKept[std::pair(cells[a], a) < std::pair(cells[b], b) ? b : a] = true;
    }
    std::vector<std::uint32_t> dropped;
    for (std::uint32_t seed = 0; seed < cells.size(); ++seed) {
        if (!isKept[seed]) dropped.push_back(seed);
    }
    return dropped;
}

}  // namespace rubble
