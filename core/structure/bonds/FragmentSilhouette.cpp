#include "core/structure/bonds/FragmentSilhouette.h"

#include "core/geometry/search/Box3.h"

#include <algorithm>

namespace rubble {
namespace {

/// Drops the last of three points that do not turn left.
void dropReflex(Ring& chain, Vec2 next, std::size_t least) {
    while (chain.size() >= least + 2) {
        const Vec2 a = chain[chain.size() - 2], b = chain.back();
        if (cross(b - a, next - b) > 0.0) return;
        chain.pop_back();
    }
}

/// Source: Andrew 1979, the monotone chain.
Ring convexHullOf(std::vector<Vec2> points) {
    std::ranges::sort(points, [](Vec2 a, Vec2 b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    Ring hull;
    for (const Vec2 point : points) {
        dropReflex(hull, point, 0);
        hull.push_back(point);
    }
    const std::size_t lower = hull.size() - 1;
    for (std::size_t k = points.size() - 1; k-- > 0;) {
        dropReflex(hull, points[k], lower);
        hull.push_back(points[k]);
    }
    hull.pop_back();
    return hull;
}

}  // namespace

Polygon silhouetteOf(const Fragment& fragment) {
    if (const std::optional<ExtrudedFragment> extruded = fragment.extruded()) return extruded->outline();
    std::vector<Vec2> points;
    for (const Polytope& hull : fragment.hulls()) {
        for (const Vec3& vertex : hull.vertices) points.emplace_back(vertex);
    }
    return {convexHullOf(std::move(points)), {}};
}

double depthOf(const Fragment& fragment) {
    if (const std::optional<ExtrudedFragment> extruded = fragment.extruded()) return extruded->depth();
    Box3 box;
    for (const Polytope& hull : fragment.hulls()) {
        for (const Vec3& vertex : hull.vertices) box.include(vertex);
    }
    return box.max.z - box.min.z;
}

}  // namespace rubble
