#include "core/fracture/partition/EdgeIndex.h"

#include <algorithm>

namespace rubble {

void EdgeIndex::add(const Partition& partition, std::uint32_t group, std::uint32_t piece) {
    forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t) {
        m_entries.push_back({group, from, to, piece});
    });
}

void EdgeIndex::sort() { std::ranges::sort(m_entries); }

std::uint32_t EdgeIndex::find(std::uint32_t group, std::uint32_t from, std::uint32_t to) const {
    const auto found = std::ranges::lower_bound(m_entries, Entry{group, from, to, 0});
    const bool isFound = found != m_entries.end() && found->group == group && found->from == from && found->to == to;
    return isFound ? found->piece : kNone;
}

}  // namespace rubble
