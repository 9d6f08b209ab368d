#include "core/structure/bonds/SharedEdges.h"

namespace rubble {

std::vector<SharedEdge> sharedEdges(const Fragments& fragments) {
    std::vector<SharedEdge> edges;
    const ExtrudedPieces* pieces = fragments.extruded();
    if (!pieces) return edges;
    const Partition& partition = pieces->partition;
    for (std::uint32_t piece = 0; piece < partition.pieceCount(); ++piece) {
        const std::uint32_t first = pieces->fragmentOfPiece[piece];
        if (first == kNone) continue;
        forEachEdge(partition, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
            const std::uint32_t second = neighbour == kNone ? kNone : pieces->fragmentOfPiece[neighbour];
            if (second != kNone && second > first) edges.push_back({first, second, from, to});
        });
    }
    return edges;
}

}  // namespace rubble
