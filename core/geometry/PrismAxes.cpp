#include "core/geometry/PrismAxes.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace rubble {
namespace {

// Faces within this of a direction are counted to it: sine of about 0.06 degrees.
constexpr double kSameDirection = 1e-3;
// How many flat parts are looked at to say why a mesh is no prism.
constexpr std::size_t kMostFlatParts = 12;

/// The mean direction of all faces that look nearly along an axis or against it: better than that of one face.
Vec3 refined(const TriangleMesh& mesh, Vec3 axis) {
    Vec3 sum{0.0, 0.0, 0.0};
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const Vec3 area = doubleArea(mesh, i);
        const double along = glm::dot(area, axis);
        if (glm::length(area - along * axis) <= kSameDirection * std::abs(along)) sum += along < 0.0 ? -area : area;
    }
    return glm::length(sum) > 0.0 ? glm::normalize(sum) : axis;
}

/// Adds an axis, tidied, unless it is there.
void addAxis(std::vector<Vec3>& axes, Vec3 axis, double size, double tolerance) {
    const Vec3 tidied = tidiedAxis(axis, size, tolerance);
    const auto isSame = [&](Vec3 other) { return glm::length(glm::cross(tidied, other)) * size <= tolerance; };
    if (std::ranges::none_of(axes, isSame)) axes.push_back(tidied);
}

/// Directions across flat parts, by their area, largest first.
std::vector<Vec3> flatDirections(const TriangleMesh& mesh) {
    std::map<std::array<int, 3>, Vec3> parts;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        Vec3 area = doubleArea(mesh, i);
        if (area == Vec3(0.0, 0.0, 0.0)) continue;
        area = tidiedAxis(glm::normalize(area), 0.0, 0.0) * glm::length(area);
        const Vec3 steps = glm::round(glm::normalize(area) / (8.0 * kSameDirection));
        parts[{static_cast<int>(steps.x), static_cast<int>(steps.y), static_cast<int>(steps.z)}] += area;
    }
    std::vector<Vec3> sums;
    for (const auto& [steps, sum] : parts) sums.push_back(sum);
    std::ranges::stable_sort(sums, std::greater<>(), [](Vec3 sum) { return glm::length(sum); });
    sums.resize(std::min(sums.size(), kMostFlatParts));
    for (Vec3& sum : sums) sum = glm::normalize(sum);
    return sums;
}

/// The triangle with the greatest value, the first of equal ones.
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

Vec3 tidiedAxis(Vec3 axis, double size, double tolerance) {
    constexpr std::array<int, 3> kOrder{2, 0, 1};
    int nearest = kOrder[0];
    for (const int k : kOrder)
        if (std::abs(axis[k]) > std::abs(axis[nearest]) + kSameDirection) nearest = k;
    if (axis[nearest] < 0.0) axis = -axis;
    Vec3 world{0.0, 0.0, 0.0};
    world[nearest] = 1.0;
    return glm::length(glm::cross(axis, world)) * size < tolerance ? world : axis;
}

std::vector<Vec3> possibleAxes(const TriangleMesh& mesh, double tolerance) {
    const double size = boundsOf(mesh).diagonal();
    const std::size_t largest = greatest(mesh, [](Vec3 area) { return glm::length(area); });
    const Vec3 first = refined(mesh, glm::normalize(doubleArea(mesh, largest)));
    const std::size_t across = greatest(mesh, [&](Vec3 area) { return glm::length(glm::cross(area, first)); });
    const Vec3 second = refined(mesh, glm::normalize(doubleArea(mesh, across)));
    std::vector<Vec3> axes;
    addAxis(axes, first, size, tolerance);
    addAxis(axes, second, size, tolerance);
    const Vec3 common = glm::cross(first, second);
    if (glm::length(common) > kSameDirection) addAxis(axes, refined(mesh, glm::normalize(common)), size, tolerance);
    return axes;
}

std::vector<Vec3> arguableAxes(const TriangleMesh& mesh, double tolerance) {
    const double size = boundsOf(mesh).diagonal();
    std::vector<Vec3> axes = possibleAxes(mesh, tolerance);
    for (const Vec3 world : {Vec3(0.0, 0.0, 1.0), Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0)})
        addAxis(axes, world, size, tolerance);
    for (const Vec3 direction : flatDirections(mesh)) addAxis(axes, refined(mesh, direction), size, tolerance);
    return axes;
}

}  // namespace rubble
