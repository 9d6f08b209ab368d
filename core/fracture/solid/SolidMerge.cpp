#include "core/fracture/solid/SolidMerge.h"

#include "core/fracture/solid/SolidContacts.h"

#include <map>
#include <set>
#include <utility>

namespace rubble {
namespace {

/// The areas of common faces between groups of merged fragments.
class MergeGraph {
public:
    explicit MergeGraph(const SolidPartition& partition)
        : m_volumes(partition.volumes), m_areas(partition.fragmentCount()), m_receivers(partition.fragmentCount()) {
        for (std::uint32_t k = 0; k < m_receivers.size(); ++k) m_receivers[k] = k;
        for (const SolidContact& contact : contactsOf(partition)) {
            m_areas[contact.first][contact.second] = contact.area;
            m_areas[contact.second][contact.first] = contact.area;
        }
    }

    void mergeBelow(double minVolume) {
        std::set<std::pair<double, std::uint32_t>> small;
        for (std::uint32_t k = 0; k < m_volumes.size(); ++k) {
            if (m_volumes[k] < minVolume) small.insert({m_volumes[k], k});
        }
        while (!small.empty()) {
            const std::uint32_t fragment = small.begin()->second;
            small.erase(small.begin());
            const std::uint32_t receiver = nearestTo(fragment);
            if (receiver == kNone) continue;
            const bool wasSmall = small.erase({m_volumes[receiver], receiver}) > 0;
            merge(fragment, receiver);
            if (wasSmall && m_volumes[receiver] < minVolume) small.insert({m_volumes[receiver], receiver});
        }
    }

    /// The fragment that each is merged into in the end.
    std::vector<std::uint32_t> receivers() const {
        std::vector<std::uint32_t> last = m_receivers;
        for (std::uint32_t& receiver : last) {
            while (m_receivers[receiver] != receiver) receiver = m_receivers[receiver];
        }
        return last;
    }

private:
    std::uint32_t nearestTo(std::uint32_t fragment) const {
        std::uint32_t nearest = kNone;
        double largest = 0.0;
        for (const auto& [other, area] : m_areas[fragment]) {
            if (area > largest) largest = area, nearest = other;
        }
        return nearest;
    }

    void merge(std::uint32_t fragment, std::uint32_t receiver) {
        m_receivers[fragment] = receiver;
        m_volumes[receiver] += m_volumes[fragment];
        for (const auto& [other, area] : m_areas[fragment]) {
            m_areas[other].erase(fragment);
            if (other == receiver) continue;
            m_areas[other][receiver] += area;
            m_areas[receiver][other] += area;
        }
        m_areas[fragment].clear();
    }

    std::vector<double> m_volumes;
    std::vector<std::map<std::uint32_t, double>> m_areas;  // of each, to its neighbours
    std::vector<std::uint32_t> m_receivers;
};

}  // namespace

SolidPartition mergedFragments(SolidPartition partition, std::span<const std::uint32_t> receivers) {
    SolidPartition merged;
    merged.origin = partition.origin;
    merged.points = std::move(partition.points);
    merged.duplicates = std::move(partition.duplicates);
    merged.fragmentOfSeed.assign(partition.fragmentOfSeed.size(), kNone);
    std::vector<std::uint32_t> numbers(partition.fragmentCount(), kNone);
    for (std::uint32_t k = 0; k < partition.fragmentCount(); ++k) {
        if (receivers[k] != k) continue;
        numbers[k] = merged.fragmentCount();
        const std::uint32_t seed = partition.seedOfFragment[k];
        if (merged.fragmentOfSeed[seed] == kNone) merged.fragmentOfSeed[seed] = numbers[k];
        merged.seedOfFragment.push_back(seed);
        merged.partOfFragment.push_back(partition.partOfFragment[k]);
    }
    merged.volumes.assign(merged.fragmentCount(), 0.0);
    for (std::uint32_t k = 0; k < partition.fragmentCount(); ++k) {
        merged.volumes[numbers[receivers[k]]] += partition.volumes[k];
    }
    for (std::uint32_t f = 0; f < partition.faces.size(); ++f) {
        SolidPartition::Face face = partition.faces[f];
        face.fragment = numbers[receivers[face.fragment]];
        if (face.behind != kNone) face.behind = numbers[receivers[face.behind]];
        if (face.fragment != face.behind) merged.addFace(face, partition.trianglesOf(f));
    }
    merged.listFaces();
    return merged;
}

SolidPartition withoutSmallFragments(SolidPartition partition, double minVolume, std::vector<std::uint32_t>* merged) {
    MergeGraph graph(partition);
    graph.mergeBelow(minVolume);
    const std::vector<std::uint32_t> receivers = graph.receivers();
    for (std::uint32_t k = 0; merged && k < receivers.size(); ++k) {
        if (receivers[k] != k) merged->push_back(k);
    }
    return mergedFragments(std::move(partition), receivers);
}

}  // namespace rubble
