#pragma once

#include "core/fracture/partition/Partition.h"

#include <cstdint>
#include <vector>

namespace rubble {

/// Finds the piece that has an edge, among the pieces of a group, in O(log edges). Call sort() after the last add().
class EdgeIndex {
public:
    /// The maximum size of groups that hasEdge() searches as fast as this index.
    static constexpr std::size_t kMaxLinear = 8;

    struct Member {
        std::uint32_t group, piece;
    };
    void add(const Partition& partition, Member member);
    void sort();

    /// The lowest piece of the group that has the edge; kNone: none.
    std::uint32_t find(std::uint32_t group, PointEdge edge) const;

private:
    struct Entry {
        std::uint32_t group, from, to, piece;
        auto operator<=>(const Entry&) const = default;
    };
    std::vector<Entry> m_entries;
};

}  // namespace rubble
