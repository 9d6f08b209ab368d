#include "core/fracture/fragments/HullSeparation.h"

#include "core/geometry/hull/ConvexHull.h"
#include "core/geometry/hull/HullOverlap.h"
#include "core/geometry/hull/SimplifiedHull.h"
#include "core/geometry/search/BoxTree.h"

#include <algorithm>
#include <optional>

namespace rubble {
namespace {

struct PlacedHull {
    std::size_t fragment = 0;
    std::size_t hull = 0;
};

Box3 boxOf(const Polytope& hull) {
    Box3 box;
    for (const Vec3& vertex : hull.vertices) box.include(vertex);
    return box;
}

/// Whether a face of one of two hulls shows that they overlap by no more than a tolerance.
bool areApart(const Polytope& first, const Polytope& second, double tolerance) {
    const auto isAbove = [&](const Plane& plane, const Polytope& other) {
        return std::ranges::all_of(other.vertices, [&](const Vec3& vertex) {
            return glm::dot(plane.normal, vertex) >= plane.offset - tolerance;
        });
    };
    return std::ranges::any_of(first.planes, [&](const Plane& plane) { return isAbove(plane, second); }) ||
           std::ranges::any_of(second.planes, [&](const Plane& plane) { return isAbove(plane, first); });
}

/// The part of a hull behind a plane, flat to a tolerance; nothing if that has no volume. Corners that the plane adds
/// are simplified, beyond kMaxCollisionCorners or as many as the hull has.
std::optional<Polytope> behind(const Polytope& hull, const Plane& plane, double tolerance) {
    std::vector<double> heights;
    for (const Vec3& vertex : hull.vertices) heights.push_back(glm::dot(plane.normal, vertex) - plane.offset);
    std::vector<Vec3> points;
    for (std::size_t k = 0; k < heights.size(); ++k)
        if (heights[k] <= 0.0) points.push_back(hull.vertices[k]);
    for (const auto& [from, to] : hull.edges) {
        if ((heights[from] <= 0.0) == (heights[to] <= 0.0)) continue;
        const double fraction = heights[from] / (heights[from] - heights[to]);
        points.push_back(hull.vertices[from] + fraction * (hull.vertices[to] - hull.vertices[from]));
    }
    if (points.size() < 4) return std::nullopt;
    Result<Polytope> part = convexHull(points, tolerance);
    if (!part) return std::nullopt;
    const std::size_t maxCorners = std::max(kMaxCollisionCorners, hull.vertices.size());
    return part->vertices.size() > maxCorners ? simplifiedHull(*part, {.maxCorners = maxCorners}) : std::move(*part);
}

/// Returns by how much they overlapped, m.
double cutApart(Polytope& first, Polytope& second, double tolerance) {
    if (areApart(first, second, tolerance)) return 0.0;
    const HullOverlap overlap = hullOverlap(first, second);
    if (overlap.depth <= tolerance) return 0.0;
    double highest = glm::dot(overlap.normal, first.vertices[0]);
    for (const Vec3& vertex : first.vertices) highest = std::max(highest, glm::dot(overlap.normal, vertex));
    for (const double part : {0.5, 0.0, 1.0}) {  // of the overlap that is cut from the first
        const double height = highest - part * overlap.depth;
        std::optional<Polytope> below =
            part > 0.0 ? behind(first, {overlap.normal, height}, 0.1 * tolerance) : std::optional(first);
        std::optional<Polytope> above =
            part < 1.0 ? behind(second, {-overlap.normal, -height}, 0.1 * tolerance) : std::optional(second);
        if (!below || !above) continue;
        first = std::move(*below);
        second = std::move(*above);
        return overlap.depth;
    }
    return 0.0;
}

}  // namespace

std::vector<double> separateHulls(std::vector<std::vector<Polytope>>& hullsOfFragments, double tolerance) {
    std::vector<double> cut(hullsOfFragments.size(), 0.0);
    std::vector<PlacedHull> hulls;
    std::vector<Box3> boxes;
    for (std::size_t fragment = 0; fragment < hullsOfFragments.size(); ++fragment) {
        for (std::size_t hull = 0; hull < hullsOfFragments[fragment].size(); ++hull) {
            hulls.push_back({fragment, hull});
            boxes.push_back(boxOf(hullsOfFragments[fragment][hull]));
        }
    }
    const BoxTree tree(boxes);
    for (std::size_t one = 0; one < hulls.size(); ++one) {
        std::vector<std::size_t> others;
        tree.visitOverlapping(boxes[one], [&](std::uint32_t other) {
            if (other > one && hulls[other].fragment != hulls[one].fragment) others.push_back(other);
        });
        std::ranges::sort(others);
        for (const std::size_t other : others) {
            const std::size_t first = hulls[one].fragment, second = hulls[other].fragment;
            const double depth = cutApart(hullsOfFragments[first][hulls[one].hull],
                                          hullsOfFragments[second][hulls[other].hull], tolerance);
            cut[first] = std::max(cut[first], depth);
            cut[second] = std::max(cut[second], depth);
        }
    }
    return cut;
}

}  // namespace rubble
