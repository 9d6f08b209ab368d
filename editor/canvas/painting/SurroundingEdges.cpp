#include "editor/canvas/painting/SurroundingEdges.h"

#include "core/asset/bake/FragmentLookup.h"

namespace rubble {

namespace {

void addEdges(const Fragments& fragments, Vec2 origin, std::vector<std::array<Vec2, 2>>& edges) {
    const Partition& shapes = fragments.shapes();
    const Vec2 offset = shapes.origin + Vec2{fragments.origin} - origin;
    for (std::uint32_t piece = 0; piece < shapes.pieceCount(); ++piece) {
        forEachEdge(shapes, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
            const bool isShared = neighbour != kNone && !fragments.shrunk;
            if (!isShared || neighbour < piece)
                edges.push_back({shapes.points[from] + offset, shapes.points[to] + offset});
        });
    }
}

}  // namespace

std::vector<std::array<Vec2, 2>> surroundingEdges(const Bake& bake, const FragmentPath& fragment) {
    std::vector<std::array<Vec2, 2>> edges;
    const std::optional<std::uint32_t> number = fragmentAt(bake, fragment);
    if (!number) return edges;
    for (std::uint32_t inner = *number; inner != kNone; inner = bake.fragment(inner).parent) {
        const BakedFracture* fracture = bake.fractureOf(bake.fragment(inner).parent);
        addEdges(fracture->fragments, Vec2{bake.fragment(*number).solid.offset()}, edges);
    }
    return edges;
}

}  // namespace rubble
