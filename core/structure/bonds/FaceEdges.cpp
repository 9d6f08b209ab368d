#include "core/structure/bonds/FaceEdges.h"

#include "core/structure/bonds/SharedEdges.h"

#include <algorithm>
#include <utility>

namespace rubble {
namespace {

/// Of each point of a partition, whether it is on the outline of all pieces.
std::vector<bool> pointsOutside(const Partition& partition) {
    std::vector<bool> isOutside(partition.points.size(), false);
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
        forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
            if (neighbour == kNone) isOutside[from] = isOutside[to] = true;
        });
    }
    return isOutside;
}

/// The bond between two fragments, first < second; kNone: there is none.
std::uint32_t bondBetween(std::span<const Bond> bonds, std::uint32_t first, std::uint32_t second) {
    const auto pairOf = [](const Bond& bond) { return std::pair(bond.first, bond.second); };
    const std::pair pair(first, second);
    const auto found = std::ranges::lower_bound(bonds, pair, {}, pairOf);
    return found != bonds.end() && pairOf(*found) == pair ? static_cast<std::uint32_t>(found - bonds.begin()) : kNone;
}

}  // namespace

std::vector<FaceEdge> faceEdges(const Fragments& fragments, std::span<const Bond> bonds) {
    std::vector<FaceEdge> edges;
    if (!fragments.extruded()) return edges;
    const Partition& partition = fragments.extruded()->partition;
    const std::vector<bool> isOutside = pointsOutside(partition);
    for (const auto& [first, second, from, to] : sharedEdges(fragments)) {
        const std::uint32_t bond = bondBetween(bonds, first, second);
        if (bond == kNone) continue;
        edges.push_back({bond, partition.origin + partition.points[from], partition.origin + partition.points[to],
                         isOutside[from], isOutside[to]});
    }
    return edges;
}

}  // namespace rubble
