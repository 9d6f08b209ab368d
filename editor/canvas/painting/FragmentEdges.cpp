#include "editor/canvas/painting/FragmentEdges.h"

#include "core/asset/bake/FragmentLookup.h"

namespace rubble {

namespace {

void addEdges(const Fragments& fragments, Vec2 origin, std::vector<std::array<Vec2, 2>>& edges) {
    if (!fragments.extruded()) return;
    const Partition& shapes = fragments.extruded()->shapes();
    const Vec2 offset = shapes.origin + Vec2{fragments.origin} - origin;
    for (std::uint32_t piece = 0; piece < shapes.pieceCount(); ++piece) {
        forEachEdge(shapes, piece, [&](std::uint32_t from, std::uint32_t to, std::uint32_t neighbour) {
            const bool isShared = neighbour != kNone && !fragments.extruded()->shrunk;
            if (!isShared || neighbour < piece)
                edges.push_back({shapes.points[from] + offset, shapes.points[to] + offset});
        });
    }
}

/// The number of a fragment, kNone for the whole asset; none if the bake does not contain it.
std::optional<std::uint32_t> numberOf(const Bake& bake, const FragmentPath& fragment) {
    return fragment.empty() ? std::optional(kNone) : fragmentAt(bake, fragment);
}

bool isWithin(const Bake& bake, std::uint32_t fragment, std::uint32_t ancestor) {
    while (fragment != kNone && fragment != ancestor) fragment = bake.fragment(fragment).parent;
    return fragment == ancestor;
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

std::vector<std::array<Vec2, 2>> deeperEdges(const Bake& bake, const FragmentPath& fragment) {
    std::vector<std::array<Vec2, 2>> edges;
    const std::optional<std::uint32_t> number = numberOf(bake, fragment);
    if (!number) return edges;
    const Vec2 origin = *number == kNone ? Vec2(0.0) : Vec2{bake.fragment(*number).solid.offset()};
    for (const BakedFracture& fracture : bake.fractures) {
        if (fracture.parent != *number && isWithin(bake, fracture.parent, *number))
            addEdges(fracture.fragments, origin, edges);
    }
    return edges;
}

const Fragments* fragmentsWithin(const Bake& bake, const FragmentPath& fragment) {
    const std::optional<std::uint32_t> number = numberOf(bake, fragment);
    const BakedFracture* fracture = number ? bake.fractureOf(*number) : nullptr;
    return fracture ? &fracture->fragments : nullptr;
}

}  // namespace rubble
