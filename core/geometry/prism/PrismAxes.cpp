#include "core/geometry/prism/PrismAxes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace rubble {
namespace {

// Sine, 0.06 degrees, of the angle within which faces have the same direction.
constexpr double kSameDirection = 1e-3;
// The number of planar regions considered in a rejection.
constexpr std::size_t kMaxPlanarRegions = 12;

/// The mean normal of all faces nearly perpendicular to an axis, which is more accurate than that of one face.
Vec3 refinedAxis(const TriangleMesh& mesh, Vec3 axis) {
    Vec3 sum{0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Vec3 area = doubleArea(mesh, i);
        const double along = glm::dot(area, axis);
        if (glm::length(area - along * axis) <= kSameDirection * std::abs(along)) sum += along < 0.0 ? -area : area;
    }
    return glm::length(sum) > 0.0 ? glm::normalize(sum) : axis;
}

/// Adds a snapped axis unless it exists.
void addAxis(std::vector<Vec3>& axes, Vec3 axis, double size, double tolerance) {
    const Vec3 snapped = snappedAxis(axis, size, tolerance);
    const auto isSame = [&](Vec3 other) { return glm::length(glm::cross(snapped, other)) * size <= tolerance; };
    if (std::ranges::none_of(axes, isSame)) axes.push_back(snapped);
}

/// The normals of planar regions, largest area first.
std::vector<Vec3> planarRegionNormals(const TriangleMesh& mesh) {
    std::map<std::array<int, 3>, Vec3> parts;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        Vec3 area = doubleArea(mesh, i);
        if (area == Vec3(0.0, 0.0, 0.0)) continue;
        area = snappedAxis(glm::normalize(area), 0.0, 0.0) * glm::length(area);
        const Vec3 steps = glm::round(glm::normalize(area) / (8.0 * kSameDirection));
        parts[{static_cast<int>(steps.x), static_cast<int>(steps.y), static_cast<int>(steps.z)}] += area;
    }
    std::vector<Vec3> sums;
    for (const auto& [steps, sum] : parts) sums.push_back(sum);
    std::ranges::stable_sort(sums, std::greater<>(), [](Vec3 sum) { return glm::length(sum); });
    sums.resize(std::min(sums.size(), kMaxPlanarRegions));
    for (Vec3& sum : sums) sum = glm::normalize(sum);
    return sums;
}

/// The triangle with the greatest value; ties go to the first.
template <class Value>
std::size_t greatest(const TriangleMesh& mesh, Value value) {
    std::size_t best = 0;
    double bestValue = -1.0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const double found = value(doubleArea(mesh, i));
        if (found <= bestValue) continue;
        best = i;
        bestValue = found;
    }
    return best;
}

}  // namespace

Vec3 snappedAxis(Vec3 axis, double size, double tolerance) {
    constexpr std::array<int, 3> kOrder{2, 0, 1};
    int nearest = kOrder[0];
    for (const int k : kOrder)
        if (std::abs(axis[k]) > std::abs(axis[nearest]) + kSameDirection) nearest = k;
    if (axis[nearest] < 0.0) axis = -axis;
    Vec3 world{0.0, 0.0, 0.0};
    world[nearest] = 1.0;
    return glm::length(glm::cross(axis, world)) * size < tolerance ? world : axis;
}

std::vector<Vec3> candidateAxes(const TriangleMesh& mesh, double tolerance) {
    const double size = boundsOf(mesh).diagonal();
    const std::size_t largest = greatest(mesh, [](Vec3 area) { return glm::length(area); });
    const Vec3 first = refinedAxis(mesh, glm::normalize(doubleArea(mesh, largest)));
    const std::size_t across = greatest(mesh, [&](Vec3 area) { return glm::length(glm::cross(area, first)); });
    const Vec3 second = refinedAxis(mesh, glm::normalize(doubleArea(mesh, across)));
    std::vector<Vec3> axes;
    addAxis(axes, first, size, tolerance);
    addAxis(axes, second, size, tolerance);
    const Vec3 common = glm::cross(first, second);
    if (glm::length(common) > kSameDirection) addAxis(axes, refinedAxis(mesh, glm::normalize(common)), size, tolerance);
    return axes;
}

std::vector<Vec3> diagnosticAxes(const TriangleMesh& mesh, double tolerance) {
    const double size = boundsOf(mesh).diagonal();
    std::vector<Vec3> axes = candidateAxes(mesh, tolerance);
    for (const Vec3 world : {Vec3(0.0, 0.0, 1.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0)})
        addAxis(axes, world, size, tolerance);
    for (const Vec3 direction : planarRegionNormals(mesh)) addAxis(axes, refinedAxis(mesh, direction), size, tolerance);
    return axes;
}

}  // namespace rubble
