#include "core/asset/bake/SolidShaping.h"

#include "core/base/QuantityText.h"
#include "core/fracture/partition/CappedDiagnostics.h"
#include "core/fracture/planes/SolidSplit.h"
#include "core/fracture/solid/SolidContacts.h"
#include "core/fracture/solid/SolidMerge.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <span>
#include <unordered_map>

namespace rubble {
namespace {

std::string nameOf(const SolidPartition& partition, std::uint32_t fragment, const Seeds& seeds) {
    const std::uint32_t part = partition.partOfFragment[fragment];
    const SeedId id = seeds.ids.empty() ? SeedId{} : seeds.ids[partition.seedOfFragment[fragment]];
    return id.text() + (part == kNone ? "" : "." + std::to_string(part));
}

/// Applies edits to the fragments of one fracture, in order. Merges are carried out together before the next split,
/// since each renumbers all fragments.
class SolidEditor {
public:
    SolidEditor(SolidPartition&& partition, const Seeds& seeds, Vec2 offset, const TaskContext& task)
        : m_partition(std::move(partition)),
          m_seeds(seeds),
          m_offset(offset),
          m_task(task),
          m_freeParts(m_partition.fragmentOfSeed.size()) {
        for (std::uint32_t k = 0; k < m_partition.fragmentCount(); ++k) {
            std::uint32_t& free = m_freeParts[m_partition.seedOfFragment[k]];
            if (m_partition.partOfFragment[k] != kNone) free = std::max(free, m_partition.partOfFragment[k] + 1);
        }
        registerFragments();
    }

    Status apply(const FragmentMerge& merge) {
        const std::uint32_t into = find(merge.into);
        if (into == kNone) return lost(merge.into, "does not exist; nothing is merged into it.");
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
        return success();
    }

    /// Splits along the plane through the line along z.
    Status apply(const FragmentSplit& split) {
        mergeAll();
        const std::uint32_t fragment = find(split.fragment);
        if (fragment == kNone) return lost(split.fragment, "does not exist; it is not split.");
        const Vec2 point = split.line.point - m_offset, normal = perpendicular(split.line.direction);
        Result<SolidSplit> parts =
            splitFragment(std::move(m_partition), fragment, planeThrough(Vec3(point, 0.0), Vec3(normal, 0.0)), m_task);
        if (!parts) return parts.error();
        m_partition = std::move(parts->partition);
        if (parts->pieces.size() == 1)
            return lost(split.fragment, "does not intersect its split line; it is not split.");
        numberParts(fragment, parts->pieces);
        registerFragments();
        return success();
    }

    SolidPartition finished() && {
        mergeAll();
        return std::move(m_partition);
    }
    std::vector<Diagnostic>& reports() { return m_reports; }

private:
    /// A fragment that is not merged into another; kNone: none has the name.
    std::uint32_t find(const FragmentPath& path) const {
        const auto found = m_fragments.find(path.substr(path.rfind('/') + 1));
        return found != m_fragments.end() && m_receivers[found->second] == found->second ? found->second : kNone;
    }

    void registerFragments() {
        m_contacts.reset();
        m_receivers.resize(m_partition.fragmentCount());
        std::iota(m_receivers.begin(), m_receivers.end(), 0u);
        m_fragments.clear();
        for (std::uint32_t k = 0; k < m_receivers.size(); ++k) m_fragments[nameOf(m_partition, k, m_seeds)] = k;
    }

    /// Numbers the parts of a fragment by the numbers that are next in its cell, also after those of parts that were
    /// merged into others. The first keeps its number if it has one.
    void numberParts(std::uint32_t fragment, std::span<const std::uint32_t> parts) {
        std::uint32_t& free = m_freeParts[m_partition.seedOfFragment[fragment]];
        const bool isNumbered = free > 0;
        for (const std::uint32_t part : parts) {
            if (part != fragment || !isNumbered) m_partition.partOfFragment[part] = free++;
        }
    }

    bool areNeighbours(std::uint32_t first, std::uint32_t second) {
        if (!m_contacts) m_contacts = contactsOf(m_partition);
        return std::ranges::any_of(*m_contacts, [&](const SolidContact& contact) {
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

    /// Carries out the merges since the last split.
    void mergeAll() {
        bool isAnyMerged = false;
        for (std::uint32_t k = 0; k < m_receivers.size(); ++k) isAnyMerged = isAnyMerged || m_receivers[k] != k;
        if (!isAnyMerged) return;
        m_partition = mergedFragments(std::move(m_partition), m_receivers);
        registerFragments();
    }

    void reportLost(const FragmentPath& path, const std::string& rest) {
        m_reports.push_back(diagnostic(DiagnosticCode::LostPiece, {.path = path}, "Fragment " + path + " " + rest));
    }
    /// Reports it; the other edits are applied.
    Status lost(const FragmentPath& path, const std::string& rest) {
        reportLost(path, rest);
        return success();
    }

    SolidPartition m_partition;
    const Seeds& m_seeds;
    Vec2 m_offset;  // m
    TaskContext m_task;
    std::optional<std::vector<SolidContact>> m_contacts;  // of the partition
    std::vector<std::uint32_t> m_receivers;
    std::vector<std::uint32_t> m_freeParts;                      // of each seed: the next part number
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

Result<SolidPartition> editedFragments(SolidPartition partition, const Seeds& seeds,
                                       const std::vector<FragmentEdit>& edits, const FragmentPath& parent, Vec2 offset,
                                       std::vector<Diagnostic>& diagnostics, const TaskContext& task) {
    const auto isHere = [&](const FragmentEdit& edit) { return parentOf(edit) == parent; };
    if (std::ranges::none_of(edits, isHere)) return partition;
    SolidEditor editor(std::move(partition), seeds, offset, task);
    for (const FragmentEdit& edit : edits) {
        if (!isHere(edit)) continue;
        const Status applied = std::visit([&](const auto& one) { return editor.apply(one); }, edit);
        if (!applied) return applied.error();
    }
    std::ranges::move(editor.reports(), std::back_inserter(diagnostics));
    return std::move(editor).finished();
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
