#include "core/asset/import/EqualSolids.h"

#include <algorithm>
#include <cmath>

namespace rubble {
namespace {

constexpr double kUvTolerance = 1e-5;  // some steps of single precision around 1

/// Compares two positions, or two texture coordinates.
template <class Vec>
auto areWithin(double tolerance) {
    return [tolerance](const Vec& a, const Vec& b) { return glm::distance(a, b) <= tolerance; };
}

bool areEqual(const Ring& a, const Ring& b, double tolerance) {
    return std::ranges::equal(a, b, areWithin<Vec2>(tolerance));
}

bool areEqual(const Polygon& a, const Polygon& b, double tolerance) {
    const auto areRings = [tolerance](const Ring& one, const Ring& other) { return areEqual(one, other, tolerance); };
    return areEqual(a.outer, b.outer, tolerance) && std::ranges::equal(a.holes, b.holes, areRings);
}

bool areEqual(const CapUv& a, const CapUv& b) {
    const auto areNear = [](double one, double other) { return std::abs(one - other) <= kUvTolerance; };
    return a.isAffine == b.isAffine && a.material == b.material &&
           std::ranges::equal(a.map.coefficients, b.map.coefficients, areNear);
}

bool areEqual(const Surface& a, const Surface& b, double tolerance) {
    const auto areTriangles = [tolerance](const SurfaceTriangle& one, const SurfaceTriangle& other) {
        return one.material == other.material &&
               std::ranges::equal(one.corners, other.corners, areWithin<Vec3>(tolerance)) &&
               std::ranges::equal(one.uvs, other.uvs, areWithin<Vec2>(kUvTolerance));
    };
    return a.materials == b.materials && areEqual(a.front, b.front) && areEqual(a.back, b.back) &&
           std::ranges::equal(a.triangles, b.triangles, areTriangles);
}

/// Whether two meshes have the same triangles in the same order, and points that are near.
bool areEqual(const TriangleMesh& a, const TriangleMesh& b, double tolerance) {
    return a.triangles == b.triangles && std::ranges::equal(a.points, b.points, areWithin<Vec3>(tolerance));
}

}  // namespace

bool isEqual(const Asset& asset, const ImportedSolid& solid, double tolerance) {
    if (asset.isPrism() == solid.closed.has_value()) return false;
    if (solid.closed) return areEqual(asset.mesh()->mesh, solid.closed->mesh->mesh, tolerance);
    if (std::abs(asset.prism().depth - solid.prism->depth) > tolerance) return false;
    if (!areEqual(asset.prism().outline, solid.prism->outline, tolerance)) return false;
    if (asset.texture != solid.texture) return false;
    const Surface* surface = solid.surface.surface.get();
    if (asset.surface == nullptr || surface == nullptr) return asset.surface.get() == surface;
    return areEqual(*asset.surface, *surface, tolerance);
}

}  // namespace rubble
