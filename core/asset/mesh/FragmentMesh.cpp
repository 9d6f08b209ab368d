#include "core/asset/mesh/FragmentMesh.h"

#include "core/asset/mesh/ExtrudedMesh.h"
#include "core/asset/mesh/SolidFragmentMesh.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <span>

namespace rubble {

namespace {

// Tolerance for edges on the asset's outline, relative to its diameter.
constexpr double kOutlineTolerance = 1e-9;

/// Adds a corner of the solid's outline and the side that starts there.
void addSide(Vec2 corner, ExtrudedSide side, Ring& corners, ExtrudedSolid& solid) {
    side.from = static_cast<std::uint32_t>(solid.sides.size());
    side.to = side.from + 1;
    corners.push_back(corner);
    solid.sides.push_back(side);
}

/// Adds a ring to the solid's outline, without corners that coincide with the next one. `sideOf(i, a, b)` gives the
/// side over edge i, `between(i)` the corners inserted into it.
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

/// No inserted corners.
std::span<const Vec2> straight(std::size_t) { return {}; }

/// A side of a fragment. Without a neighbour it lies on the outline, on the parent's surface, or on a gap: it is
/// outside only if it lies on the asset's outline.
ExtrudedSide sideBetween(const OutlineIndex& outline, double tolerance, std::uint32_t neighbour, Vec2 a, Vec2 b) {
    if (neighbour != kNone) return {0, 0, FaceSide::Inside, {}};
    ExtrudedSide side{0, 0, FaceSide::Outside, outline.nearestInterval(a, b)};
    if (side.outline.distance > tolerance) side.side = FaceSide::Inside;
    return side;
}

}  // namespace

FragmentMesher::FragmentMesher(const Asset& asset) : m_asset(asset) {
    if (!asset.isPrism()) return;
    m_outline.emplace(asset.prism().outline);
    m_outlineTolerance = kOutlineTolerance * boundsOf(asset.prism().outline.outer).diagonal();
    if (asset.surface && !asset.surface->triangles.empty()) m_surface.emplace(*asset.surface);
}

Mesh FragmentMesher::fragmentMesh(const BakedFragment& fragment, const EdgeCorners& rough) const {
    const Fragment& solidFragment = fragment.solid;
    const std::optional<ExtrudedFragment> extruded = solidFragment.extruded();
    if (!extruded) return solidFragmentMesh(solidFragment, m_asset);
    const Polygon outline = extruded->outline();
    const std::vector<std::uint32_t> neighbours = extruded->edgeNeighbours();
    const auto isStraight = [](const std::vector<Vec2>& corners) { return corners.empty(); };
    const bool isPlain = std::ranges::all_of(rough, isStraight);
    ExtrudedSolid solid{{}, {}, extruded->depth(), solidFragment.offset(), solidFragment.isConvex() && isPlain};
    std::size_t firstEdge = 0;  // of the ring in `neighbours`
    const Vec2 offset{solidFragment.offset()};
    const auto sideOf = [&](std::size_t edge, Vec2 a, Vec2 b) {
        return sideBetween(*m_outline, m_outlineTolerance, neighbours[firstEdge + edge], a + offset, b + offset);
    };
    const auto between = [&](std::size_t edge) {
        return rough.empty() ? std::span<const Vec2>() : std::span<const Vec2>(rough[firstEdge + edge]);
    };
    solid.sides.reserve(neighbours.size());
    addRing(outline.outer, sideOf, between, solid.outline.outer, solid);
    firstEdge = outline.outer.size();
    for (const Ring& hole : outline.holes) {
        addRing(hole, sideOf, between, solid.outline.holes.emplace_back(), solid);
        firstEdge += hole.size();
    }
    return extrudedMesh(solid, m_asset, m_surface ? &*m_surface : nullptr);
}

Mesh FragmentMesher::wholeMesh(const Bake& bake) const {
    if (const ClosedMesh* mesh = m_asset.mesh()) return solidWholeMesh(*mesh, bake.whole.centre);
    const Polygon outline = withCanonicalWinding(m_asset.prism().outline);
    const Vec3 centre = bake.whole.centre;
    ExtrudedSolid solid{{}, {}, m_asset.prism().depth, centre, bake.wholeHulls.size() <= 1};
    const auto sideOf = [&](std::size_t, Vec2 a, Vec2 b) {
        const Vec2 offset{centre.x, centre.y};
        return ExtrudedSide{0, 0, FaceSide::Outside, m_outline->nearestInterval(a + offset, b + offset)};
    };
    const auto addMoved = [&](Ring ring, Ring& corners) {
        for (Vec2& corner : ring) corner -= Vec2(centre.x, centre.y);
        addRing(ring, sideOf, straight, corners, solid);
    };
    addMoved(outline.outer, solid.outline.outer);
    for (const Ring& hole : outline.holes) addMoved(hole, solid.outline.holes.emplace_back());
    return extrudedMesh(solid, m_asset, m_surface ? &*m_surface : nullptr);
}

Mesh fragmentMesh(const BakedFragment& fragment, const Asset& asset, const EdgeCorners& rough) {
    return FragmentMesher(asset).fragmentMesh(fragment, rough);
}

Mesh wholeMesh(const Bake& bake, const Asset& asset) { return FragmentMesher(asset).wholeMesh(bake); }

}  // namespace rubble
