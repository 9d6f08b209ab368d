#include "editor/canvas/SurroundingEdges.h"

#include "core/asset/FragmentPlace.h"

namespace rubble {

namespace {

void addEdges(const Fragments& fragments, Vec2 origin, std::vector<std::array<Vec2, 2>>& edges) {
    const Partition& shapes = fragments.shapes();
    const Vec2 by = shapes.origin + Vec2{fragments.origin} - origin;
    for (std::uint32_t piece = 0; piece < shapes.pieceCount(); ++piece) {
        forEachEdge(shapes, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t across) {
            const bool isShared = across != kNone && fragments.shrunk.ringsOfPiece.empty();
            if (!isShared || across < piece) edges.push_back({shapes.points[from] + by, shapes.points[to] + by});
        });
    }
}

}  // namespace

std::vector<std::array<Vec2, 2>> edgesAround(const Bake& bake, const FragmentPath& fragment) {
    std::vector<std::array<Vec2, 2>> edges;
    const std::optional<std::uint32_t> number = fragmentAt(bake, fragment);
    if (!number) return edges;
    for (std::uint32_t inner = *number; inner != kNone; inner = bake.fragment(inner).parent) {
        const BakedBreaking* breaking = bake.breakingOf(bake.fragment(inner).parent);
        addEdges(breaking->fragments, Vec2{bake.fragment(*number).solid.offset()}, edges);
    }
    return edges;
}

}  // namespace rubble
