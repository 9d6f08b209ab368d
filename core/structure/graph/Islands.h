#pragma once

#include "core/structure/graph/BondDamage.h"
#include "core/structure/graph/BondGraph.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// One of several Islands.
struct Island {
    std::span<const std::uint32_t> nodes;  // ascending
    bool isAnchored = false;               // one of them has an unbroken bond to an anchor
};

/// The sets of nodes that unbroken bonds connect, by smallest node. All arrays are flat; use operator[] to read them.
struct Islands {
    std::vector<std::uint32_t> nodes;
    std::vector<std::uint32_t> firstNode;     // islands + 1
    std::vector<std::uint8_t> anchoredFlags;  // one per island: 1 if anchored

    std::uint32_t count() const { return static_cast<std::uint32_t>(anchoredFlags.size()); }
    Island operator[](std::uint32_t island) const {
        const std::uint32_t begin = firstNode[island], end = firstNode[island + 1];
        return {std::span(nodes).subspan(begin, end - begin), anchoredFlags[island] != 0};
    }
};

/// The islands of some nodes, ascending, by the unbroken bonds between them; `damage` has one per bond of the graph.
/// Nearly O(nodes + their bonds), and one pass over a flag for each node of the graph. Five arrays are allocated.
Islands islandsOf(const BondGraph& graph, std::span<const BondDamage> damage, std::span<const std::uint32_t> nodes);

/// The same, of nodes that were one island until some bonds broke, `broken`. Follows bonds only in what came off and
/// around what broke, where a small hole in a large wall takes little, and to the first anchor of an island, and else
/// copies the nodes and flags for those of the graph. With many broken bonds, the same as islandsOf().
/// Source: the searches of Even, Shiloach 1981, "An on-line edge-deletion problem", from all ends at once.
Islands islandsAfter(const BondGraph& graph, std::span<const BondDamage> damage, std::span<const std::uint32_t> nodes,
                     std::span<const std::uint32_t> broken);

}  // namespace rubble
