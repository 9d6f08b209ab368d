#include "core/asset/Bake.h"
#include "core/asset/ExtrudedMesh.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <span>

namespace rubble {

namespace {

// An edge nearer to the asset's outline than this part of its diameter lies on it.
constexpr double kOnOutline = 1e-9;

/// Adds a corner of the solid's outline and the side that it begins.
void addSide(Vec2 corner, ExtrudedSide side, Ring& corners, ExtrudedSolid& solid) {
    side.from = static_cast<std::uint32_t>(solid.sides.size());
    side.to = side.from + 1;
    corners.push_back(corner);
    solid.sides.push_back(side);
}

/// A ring's corners in the solid's outline, without those that fell together with the corner after them.
/// `sideOf(i)` tells what lies behind the ring's edge i, `between(i)` which corners stand between its ends.
template <class SideOf, class Between>
void addRing(const Ring& ring, SideOf sideOf, Between between, Ring& corners, ExtrudedSolid& solid) {
    const auto first = static_cast<std::uint32_t>(solid.sides.size());
    corners.reserve(ring.size());
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::size_t next = i + 1 < ring.size() ? i + 1 : 0;
        if (ring[i] == ring[next]) continue;
        ExtrudedSide side = sideOf(i, ring[i], ring[next]);
        addSide(ring[i], side, corners, solid);
        for (const Vec2 corner : between(i)) {
            side.start += glm::distance(corners.back(), corner);
            addSide(corner, side, corners, solid);
        }
    }
    if (solid.sides.size() > first) solid.sides.back().to = first;
}

/// No corners between: edges stay straight.
std::span<const Vec2> straight(std::size_t) { return {}; }

ExtrudedSide outsideSide(const Asset& asset, Vec2 a, Vec2 b) {
    return {0, 0, FaceSide::Outside, outlineStretch(asset.prism.outline, a, b)};
}

/// A side of a fragment. Nobody behind it means the outline, or below the first level the surface of the parent, or else somebody
/// who went in a gap: it is outside only where it lies on the asset's own outline.
ExtrudedSide sideBetween(const BakedFragment& fragment, const Asset& asset, std::uint32_t across, Vec2 a, Vec2 b) {
    if (across != kNone) return {0, 0, FaceSide::Inside, {}};
    const Vec2 offset{fragment.solid.offset()};
    ExtrudedSide side = outsideSide(asset, a + offset, b + offset);
    const double reach = kOnOutline * boundsOf(asset.prism.outline.outer).diagonal();
    if (side.stretch.distance > reach) side.side = FaceSide::Inside;
    return side;
}

}  // namespace

Mesh fragmentMesh(const BakedFragment& fragment, const Asset& asset, const EdgeCorners& rough) {
    const Fragment& piece = fragment.solid;
    const Polygon outline = piece.outline();
    const std::vector<std::uint32_t> across = piece.across();
    const auto isStraight = [](const std::vector<Vec2>& corners) { return corners.empty(); };
    const bool isPlain = std::ranges::all_of(rough, isStraight);
    ExtrudedSolid solid{{}, {}, piece.depth(), piece.offset(), piece.isConvex() && isPlain};
    std::size_t firstEdge = 0;  // of the ring in `across`
    const auto sideOf = [&](std::size_t edge, Vec2 a, Vec2 b) {
        return sideBetween(fragment, asset, across[firstEdge + edge], a, b);
    };
    const auto between = [&](std::size_t edge) {
        return rough.empty() ? std::span<const Vec2>() : std::span<const Vec2>(rough[firstEdge + edge]);
    };
    solid.sides.reserve(across.size());
    addRing(outline.outer, sideOf, between, solid.outline.outer, solid);
    firstEdge = outline.outer.size();
    for (const Ring& hole : outline.holes) {
        addRing(hole, sideOf, between, solid.outline.holes.emplace_back(), solid);
        firstEdge += hole.size();
    }
    return extrudedMesh(solid, asset);
}

Mesh wholeMesh(const Bake& bake, const Asset& asset) {
    const Polygon outline = withCanonicalWinding(asset.prism.outline);
    const Vec3 centre = bake.whole.centre;
    ExtrudedSolid solid{{}, {}, asset.prism.depth, centre, bake.wholeHulls.size() <= 1};
    const auto sideOf = [&](std::size_t, Vec2 a, Vec2 b) {
        const Vec2 offset{centre.x, centre.y};
        return outsideSide(asset, a + offset, b + offset);
    };
    const auto addMoved = [&](Ring ring, Ring& corners) {
        for (Vec2& corner : ring) corner -= Vec2(centre.x, centre.y);
        addRing(ring, sideOf, straight, corners, solid);
    };
    addMoved(outline.outer, solid.outline.outer);
    for (const Ring& hole : outline.holes) addMoved(hole, solid.outline.holes.emplace_back());
    return extrudedMesh(solid, asset);
}

}  // namespace rubble
