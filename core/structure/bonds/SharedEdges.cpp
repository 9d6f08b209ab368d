#include "core/structure/bonds/SharedEdges.h"

namespace rubble {

std::vector<SharedEdge> sharedEdges(const Fragments& fragments) {
    const Partition& partition = fragments.partition;
    std::vector<SharedEdge> edges;
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
        const std::uint32_t first = fragments.fragmentOfPiece[piece];
        if (first == kNone) continue;
        forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
            const std::uint32_t second = neighbour == kNone ? kNone : fragments.fragmentOfPiece[neighbour];
            if (second != kNone && second > first) edges.push_back({first, second, from, to});
        });
    }
    return edges;
}

}  // namespace rubble
