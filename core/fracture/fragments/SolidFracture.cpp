#include "core/fracture/fragments/SolidFracture.h"

#include "core/base/Parallel.h"

namespace rubble {
namespace {

/// Lists the contacts of each fragment. They ascend by first, then second, so those of a fragment do by the other.
void listContacts(SolidFragments& all) {
    all.firstContact.assign(all.partition.fragmentCount() + 1, 0);
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

}  // namespace

Result<Fragments> solidFragments(SolidPartition partition, const HullLimits& limits, const TaskContext& task) {
    SolidFragments all{.partition = std::move(partition)};
    Result<std::vector<std::vector<Polytope>>> hulls = fragmentHulls(all.partition, limits, task);
    if (!hulls) return hulls.error();
    all.hulls = std::move(*hulls);
    all.masses.resize(all.partition.fragmentCount());
    forEachIndex(all.masses.size(), task.threads, [&](std::size_t k) {
        const TriangleMesh mesh = meshOf(all.partition, static_cast<std::uint32_t>(k));
        all.masses[k] = massOf(mesh.points, mesh.triangles);
        for (Polytope& hull : all.hulls[k]) hull = translated(std::move(hull), -all.masses[k].centre);
    });
    all.contacts = contactsOf(all.partition);
    listContacts(all);
    return Fragments{.parts = std::move(all)};
}

}  // namespace rubble
