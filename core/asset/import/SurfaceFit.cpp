#include "core/asset/import/SurfaceFit.h"

#include "core/asset/mesh/OutlineInterval.h"
#include "core/asset/mesh/SurfaceUv.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <map>

namespace rubble {
namespace {

// Accuracy of affine maps relative to the extent of a cap's UVs: single precision, and the rotation of the mesh.
constexpr double kRelativeUvTolerance = 1e-5;
// Coefficients are rounded to multiples of its reciprocal, so that files contain 0.5 instead of 0.49999999999999994.
constexpr double kUvDecimals = 1e9;

Vec2 flat(Vec3 point) { return {point.x, point.y}; }

bool liesOnCap(const SurfaceTriangle& triangle, double height, double tolerance) {
    const auto isOnCap = [&](Vec3 corner) { return std::abs(corner.z - height) <= tolerance; };
    return std::ranges::all_of(triangle.corners, isOnCap);
}

double areaOf(const SurfaceTriangle& triangle) {
    const auto& [a, b, c] = triangle.corners;
    return glm::length(glm::cross(b - a, c - a)) / 2.0;
}

/// The least-squares affine map of the corners about their mean; nothing if they are collinear.
std::optional<AffineUv> leastSquaresMap(const std::vector<const SurfaceTriangle*>& triangles) {
    Vec2 mean{0.0, 0.0}, meanUv{0.0, 0.0};
    const double weight = 1.0 / (3.0 * static_cast<double>(triangles.size()));
    for (const SurfaceTriangle* triangle : triangles) {
        for (int k = 0; k < 3; ++k) {
            mean += weight * flat(triangle->corners[k]);
            meanUv += weight * triangle->uvs[k];
        }
    }
    double xx = 0.0, xy = 0.0, yy = 0.0;
    Vec2 xUv{0.0, 0.0}, yUv{0.0, 0.0};
    for (const SurfaceTriangle* triangle : triangles) {
        for (int k = 0; k < 3; ++k) {
            const Vec2 offset = flat(triangle->corners[k]) - mean, uv = triangle->uvs[k] - meanUv;
            xx += offset.x * offset.x;
            xy += offset.x * offset.y;
            yy += offset.y * offset.y;
            xUv += offset.x * uv;
            yUv += offset.y * uv;
        }
    }
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 0.0)) return std::nullopt;
    const Vec2 alongX = (yy * xUv - xy * yUv) / determinant, alongY = (xx * yUv - xy * xUv) / determinant;
    const Vec2 start = meanUv - alongX * mean.x - alongY * mean.y;
    AffineUv map{{alongX.x, alongY.x, start.x, alongX.y, alongY.y, start.y}};
    for (double& coefficient : map.coefficients) coefficient = std::round(coefficient * kUvDecimals) / kUvDecimals;
    return map;
}

double deviationOf(const AffineUv& map, const std::vector<const SurfaceTriangle*>& triangles) {
    double largest = 0.0;
    for (const SurfaceTriangle* triangle : triangles)
        for (int k = 0; k < 3; ++k)
            largest = std::max(largest, glm::distance(mapped(map, flat(triangle->corners[k])), triangle->uvs[k]));
    return largest;
}

double uvTolerance(const std::vector<const SurfaceTriangle*>& triangles) {
    Box2 box;
    for (const SurfaceTriangle* triangle : triangles)
        for (const Vec2 uv : triangle->uvs) box.include(uv);
    return std::max(kRelativeUvTolerance * box.diagonal(), 1.0 / kUvDecimals);
}

/// Fits one cap. It is affine only if the cap has a single material.
CapFit fitCap(const std::vector<SurfaceTriangle>& all, double height, double tolerance, CapUv& cap) {
    std::vector<const SurfaceTriangle*> triangles;
    std::map<std::uint32_t, double> areas;
    for (const SurfaceTriangle& triangle : all) {
        if (!liesOnCap(triangle, height, tolerance)) continue;
        triangles.push_back(&triangle);
        areas[triangle.material] += areaOf(triangle);
    }
    CapFit fit{triangles.size(), areas.size(), std::nullopt};
    if (triangles.empty()) return fit;
    cap.material = std::ranges::max_element(areas, {}, [](const auto& area) { return area.second; })->first;
    if (const std::optional<AffineUv> map = leastSquaresMap(triangles)) {
        fit.deviation = deviationOf(*map, triangles);
        cap.isAffine = areas.size() == 1 && *fit.deviation <= uvTolerance(triangles);
        if (cap.isAffine) cap.map = *map;
    }
    return fit;
}

/// The position of a corner along the outline's edge that is nearest to the triangle's centroid.
double lengthAlong(const OutlineIndex& outline, const SurfaceTriangle& triangle, Vec3 corner) {
    const Vec2 middle = flat(triangle.corners[0] + triangle.corners[1] + triangle.corners[2]) / 3.0;
    return std::abs(outline.nearestInterval(flat(corner), 2.0 * middle - flat(corner)).from);
}

/// Sets the UVs of a prism without a mesh.
void setDefaultUvs(std::vector<SurfaceTriangle>& triangles, const Prism& prism, double tolerance) {
    const OutlineIndex outline(prism.outline);
    for (SurfaceTriangle& triangle : triangles) {
        const bool isCap =
            liesOnCap(triangle, prism.depth / 2.0, tolerance) || liesOnCap(triangle, -prism.depth / 2.0, tolerance);
        for (int k = 0; k < 3; ++k) {
            const Vec3 corner = triangle.corners[k];
            triangle.uvs[k] = isCap ? flat(corner) : Vec2(lengthAlong(outline, triangle, corner), corner.z);
        }
    }
}

/// Keeps only the materials in use, in the order of the file.
void keepUsedMaterials(std::vector<SurfaceTriangle>& triangles, const std::vector<std::string>& names,
                       Surface& surface) {
    std::map<std::uint32_t, std::uint32_t> used;
    for (const SurfaceTriangle& triangle : triangles) used[triangle.material] = 0;
    for (auto& [material, index] : used) {
        index = static_cast<std::uint32_t>(surface.materials.size());
        surface.materials.push_back(names[material]);
    }
    for (SurfaceTriangle& triangle : triangles) triangle.material = used[triangle.material];
}

}  // namespace

FittedSurface fittedSurface(std::span<const SurfaceTriangle> source, bool hasUvs,
                            const std::vector<std::string>& materials, const Prism& prism, double tolerance) {
    FittedSurface fitted;
    Surface surface;
    std::vector<SurfaceTriangle> triangles(source.begin(), source.end());
    keepUsedMaterials(triangles, materials, surface);
    if (!hasUvs && surface.materials.size() <= 1) return fitted;
    if (!hasUvs) setDefaultUvs(triangles, prism, tolerance);
    const double front = prism.depth / 2.0;
    fitted.front = fitCap(triangles, front, tolerance, surface.front);
    fitted.back = fitCap(triangles, -front, tolerance, surface.back);
    std::erase_if(triangles, [&](const SurfaceTriangle& triangle) {  // replaced by the map
        return (surface.front.isAffine && liesOnCap(triangle, front, tolerance)) ||
               (surface.back.isAffine && liesOnCap(triangle, -front, tolerance));
    });
    surface.triangles = std::move(triangles);
    fitted.surface = std::make_shared<const Surface>(std::move(surface));
    return fitted;
}

}  // namespace rubble
