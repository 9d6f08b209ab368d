#pragma once

#include "core/geometry/search/BoxTree.h"
#include "core/structure/bonds/Bond.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// A bond of a node, as seen from there.
struct BondLink {
    std::uint32_t node = kNone;  // at the other end; kNone: an anchor
    std::uint32_t bond = 0;
};

/// The nodes of a structure and the bonds between them. It never changes: what has broken is kept beside it, one
/// BondDamage a bond. Made by bondGraph().
struct BondGraph {
    std::vector<Vec3> centres;             // m: the centre of mass of each node, in the structure's frame
    std::vector<Bond> bonds;               //
    std::vector<std::uint32_t> firstLink;  // nodes + 1
    std::vector<BondLink> links;           // of each node, ascending bond
    BoxTree centroids;                     // of the bonds

    std::uint32_t nodeCount() const { return static_cast<std::uint32_t>(centres.size()); }
    std::uint32_t bondCount() const { return static_cast<std::uint32_t>(bonds.size()); }
    std::span<const BondLink> linksOf(std::uint32_t node) const {
        return std::span(links).subspan(firstLink[node], firstLink[node + 1] - firstLink[node]);
    }
};

/// The graph of bonds, in any order, between nodes. O(n log n).
BondGraph bondGraph(std::vector<Vec3> centres, std::vector<Bond> bonds);

}  // namespace rubble
