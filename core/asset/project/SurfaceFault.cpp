#include "core/asset/project/SurfaceFault.h"

#include "core/asset/project/Ranges.h"
#include "core/base/Utf8.h"

#include <algorithm>

namespace rubble {
namespace {

/// Whether a triangle has no cornerFault(); a surface can have millions of triangles, so no text is made.
bool areNumbersValid(const SurfaceTriangle& triangle) {
    const NumberRange &coordinates = rangeOf(ProjectNumber::OutlineCoordinate),
                      &textures = rangeOf(ProjectNumber::TextureCoordinate);
    return std::ranges::all_of(triangle.corners,
                               [&](const Vec3& corner) {
                                   return coordinates.contains(corner.x) && coordinates.contains(corner.y) &&
                                          coordinates.contains(corner.z);
                               }) &&
           std::ranges::all_of(triangle.uvs,
                               [&](const Vec2& uv) { return textures.contains(uv.x) && textures.contains(uv.y); });
}

std::optional<std::string> cornerFault(const std::string& triangle, const SurfaceTriangle& surface) {
    for (const Vec3& corner : surface.corners) {
        if (auto fault = rangeFault(triangle, ProjectNumber::OutlineCoordinate, corner, "corner")) return fault;
    }
    for (const Vec2& uv : surface.uvs) {
        if (auto fault = rangeFault(triangle, {{ProjectNumber::TextureCoordinate, uv.x, "texture coordinate u"},
                                               {ProjectNumber::TextureCoordinate, uv.y, "texture coordinate v"}})) {
            return fault;
        }
    }
    return std::nullopt;
}

}  // namespace

std::optional<std::string> surfaceFault(const std::string& owner, const Surface& surface) {
    const auto isNamed = [&](std::uint32_t material) {
        return material < std::max<std::size_t>(surface.materials.size(), 1);
    };
    if (!std::ranges::all_of(surface.materials, isUtf8)) {
        return owner + ": a material of the surface has a name that is not text in UTF-8.";
    }
    for (std::size_t k = 0; k < surface.triangles.size(); ++k) {
        if (areNumbersValid(surface.triangles[k]) && isNamed(surface.triangles[k].material)) continue;
        const std::string triangle = owner + ": triangle " + std::to_string(k) + " of the surface";
        if (auto fault = cornerFault(triangle, surface.triangles[k])) return fault;
        return triangle + " refers to a material that does not exist.";
    }
    for (const CapUv* cap : {&surface.front, &surface.back}) {
        const std::string name = owner + ": the surface's " + (cap == &surface.front ? "front" : "back") + " cap";
        if (!isNamed(cap->material)) return name + " refers to a material that does not exist.";
        for (const double coefficient : cap->map.coefficients) {
            if (auto fault = rangeFault(name, {{ProjectNumber::TextureCoordinate, coefficient, "UV map"}})) {
                return fault;
            }
        }
    }
    return std::nullopt;
}

}  // namespace rubble
