#include "core/fracture/partition/EdgeIndex.h"

#include <algorithm>

namespace rubble {

void EdgeIndex::add(const Partition& partition, Member member) {
    forEachEdge(partition, member.piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t) {
        m_entries.push_back({member.group, from, to, member.piece});
    });
}

void EdgeIndex::sort() { std::ranges::sort(m_entries); }

std::uint32_t EdgeIndex::find(std::uint32_t group, PointEdge edge) const {
    const auto found = std::ranges::lower_bound(m_entries, Entry{group, edge.from, edge.to, 0});
    const bool isFound = found != m_entries.end() && found->group == group && PointEdge{found->from, found->to} == edge;
    return isFound ? found->piece : kNone;
}

}  // namespace rubble
