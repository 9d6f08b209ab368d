#include "core/fracture/fragments/SolidFracture.h"

#include "core/base/Parallel.h"
#include "core/base/QuantityText.h"
#include "core/fracture/fragments/HullSeparation.h"
#include "core/fracture/partition/CappedDiagnostics.h"

#include <algorithm>

namespace rubble {
namespace {

constexpr double kOverlapTolerance = 1e-7;  // of the solid: hulls that overlap by less touch

/// Lists the contacts of each fragment. They ascend by first, then second, so those of a fragment do by the other.
void listContacts(SolidFragments& all) {
    all.firstContact.assign(all.count() + 1, 0);
    for (const SolidContact& contact : all.contacts) {
        ++all.firstContact[contact.first + 1];
        ++all.firstContact[contact.second + 1];
    }
    for (std::size_t k = 1; k < all.firstContact.size(); ++k) all.firstContact[k] += all.firstContact[k - 1];
    all.contactsOfFragment.resize(2 * all.contacts.size());
    std::vector<std::uint32_t> next(all.firstContact.begin(), all.firstContact.end() - 1);
    const auto list = [&](std::uint32_t SolidContact::*fragment) {
        for (std::uint32_t k = 0; k < all.contacts.size(); ++k)
            all.contactsOfFragment[next[all.contacts[k].*fragment]++] = k;
    };
    list(&SolidContact::second);
    list(&SolidContact::first);
}

/// Makes the fragments of a partition, less a gap.
class SolidFragmentMaker {
public:
    SolidFragmentMaker(SolidPartition&& partition, double gap, const HullLimits& limits, const TaskContext& task)
        : m_gap(gap), m_limits(limits), m_task(task) {
        m_all.partition = std::move(partition);
    }

    Result<Fragments> make() && {
        if (m_gap > 0.0) {
            Result<ShrunkSolid> shrunk = shrunkFragments(m_all.partition, m_gap, m_task);
            if (!shrunk) return shrunk.error();
            m_all.shrunk = std::make_shared<const ShrunkSolid>(std::move(*shrunk));
            m_diagnostics = m_all.shrunk->diagnostics;
        }
        if (const Status made = makeHulls(); !made) return made.error();
        makeMasses();
        keepContacts();
        listContacts(m_all);
        if (m_gap > 0.0) reportGap();
        return Fragments{.parts = std::move(m_all), .gap = m_gap, .diagnostics = std::move(m_diagnostics)};
    }

private:
    bool isEmpty(std::uint32_t fragment) const {
        return m_all.shrunk && m_all.shrunk->fragments[fragment].mesh.triangles.empty();
    }

    /// Makes the hulls of what remains. Fragments that a gap makes too thin for one are omitted.
    Status makeHulls() {
        std::vector<std::uint32_t> numbers;
        for (std::uint32_t k = 0; k < m_all.partition.fragmentCount(); ++k) {
            if (!isEmpty(k)) numbers.push_back(k);
        }
        std::vector<Result<std::vector<Polytope>>> each = hullsOfEach(
            numbers.size(), [&](std::uint32_t k) { return meshOf(numbers[k]); }, m_limits, m_task);
        if (m_task.isCancelled()) return TaskContext::cancelled();
        CappedDiagnostics vanished;
        for (std::size_t k = 0; k < numbers.size(); ++k) {
            if (each[k]) {
                m_numbers.push_back(numbers[k]);
                m_all.hulls.push_back(std::move(*each[k]));
            } else if (m_all.shrunk && each[k].error().code == ErrorCode::Degenerate) {
                vanished.add(DiagnosticCode::VanishedPiece,
                             [&] { return vanishedReport(m_all.partition, numbers[k]); });
            } else {
                return Error{each[k].error().code,
                             "Fragment " + std::to_string(numbers[k]) + " has no hull: " + each[k].error().message};
            }
        }
        std::ranges::move(std::move(vanished).list(), std::back_inserter(m_diagnostics));
        separate();
        if (m_numbers.size() < m_all.partition.fragmentCount()) m_all.remaining = m_numbers;
        return success();
    }

    /// Cuts the hulls of different fragments apart.
    void separate() {
        Box3 box;
        for (const Vec3& point : m_all.partition.points) box.include(point);
        m_all.hullsCutBack = separateHulls(m_all.hulls, kOverlapTolerance * box.diagonal());
    }

    TriangleMesh meshOf(std::uint32_t number) const {
        return m_all.shrunk ? m_all.shrunk->fragments[number].mesh : rubble::meshOf(m_all.partition, number);
    }

    void makeMasses() {
        m_all.masses.resize(m_numbers.size());
        forEachIndex(m_all.masses.size(), m_task.threads, [&](std::size_t k) {
            const TriangleMesh mesh = meshOf(m_numbers[k]);
            m_all.masses[k] = massOf(mesh.points, mesh.triangles);
            for (Polytope& hull : m_all.hulls[k]) hull = translated(std::move(hull), -m_all.masses[k].centre);
        });
    }

    /// Finds the contacts between fragments that remain.
    void keepContacts() {
        std::vector<std::uint32_t> fragments(m_all.partition.fragmentCount(), kNone);
        for (std::uint32_t k = 0; k < m_numbers.size(); ++k) fragments[m_numbers[k]] = k;
        m_all.contacts = contactsOf(m_all.partition);
        for (SolidContact& contact : m_all.contacts) {
            contact.first = fragments[contact.first];
            contact.second = fragments[contact.second];
        }
        std::erase_if(m_all.contacts,
                      [](const SolidContact& contact) { return contact.first == kNone || contact.second == kNone; });
    }

    void reportGap() {
        for (const double volume : m_all.partition.volumes) m_all.gapVolume += volume;
        for (const MassProperties& mass : m_all.masses) m_all.gapVolume -= mass.volume;
        m_diagnostics.push_back(diagnostic(
            DiagnosticCode::Gap, {},
            "The gap between fragments takes " + quantityText(QuantityKind::Volume, m_all.gapVolume) + " from them.",
            m_all.gapVolume));
    }

    SolidFragments m_all;
    double m_gap;  // m
    HullLimits m_limits;
    TaskContext m_task;
    std::vector<std::uint32_t> m_numbers;  // of the fragments, in the partition
    std::vector<Diagnostic> m_diagnostics;
};

}  // namespace

std::size_t SolidFragments::triangleCount(std::uint32_t fragment) const {
    std::size_t count = 0;
    for (const SolidPartition::FaceSide& side : partition.facesOf(numberInPartition(fragment)))
        count += partition.trianglesOf(side.face).size();
    return count;
}

TriangleMesh SolidFragments::meshOf(std::uint32_t fragment) const {
    const std::uint32_t number = numberInPartition(fragment);
    return shrunk ? shrunk->fragments[number].mesh : rubble::meshOf(partition, number);
}

Result<Fragments> solidFragments(SolidPartition partition, double gap, const HullLimits& limits,
                                 const TaskContext& task) {
    return SolidFragmentMaker(std::move(partition), gap, limits, task).make();
}

}  // namespace rubble
