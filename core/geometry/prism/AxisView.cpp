#include "core/geometry/prism/AxisView.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <set>

namespace rubble {
namespace {

// Cosine, 25 degrees, of the angle to the vertical below which an axis counts as upright.
constexpr double kUpright = 0.9;

Vec2 flat(Vec3 point) { return {point.x, point.y}; }

/// The mean of the heights within the tolerance of a limit; exact for equal heights.
double meanHeightNear(const std::vector<Vec3>& points, double limit, double tolerance) {
    double sum = 0.0;
    int count = 0;
    for (const Vec3 point : points) {
        if (std::abs(point.z - limit) > tolerance) continue;
        sum += point.z - limit;
        ++count;
    }
    return limit + sum / count;
}

}  // namespace

Vec3 ViewFrame::fromWorld(Vec3 point) const {
    const Vec3 offset = point - origin;
    return {glm::dot(offset, x), glm::dot(offset, y), glm::dot(offset, z)};
}

ViewFrame frameAlong(Vec3 axis, Vec3 origin) {
    ViewFrame frame{.origin = origin, .z = axis};
    if (std::abs(axis.y) < kUpright) {
        frame.x = glm::normalize(glm::cross(Vec3(0.0, 1.0, 0.0), axis));
        frame.y = glm::cross(axis, frame.x);
    } else {
        frame.y = glm::normalize(glm::cross(axis, Vec3(1.0, 0.0, 0.0)));
        frame.x = glm::cross(frame.y, axis);
    }
    return frame;
}

bool AxisView::has(FaceOrientation orientation) const {
    return std::ranges::find(orientations, orientation) != orientations.end();
}

AxisView viewAlong(const TriangleMesh& mesh, const ViewFrame& frame, double tolerance) {
    AxisView view{.frame = frame};
    double lowest = 1e308, highest = -1e308;
    for (const Vec3 point : mesh.points) {
        view.points.push_back(frame.fromWorld(point));
        lowest = std::min(lowest, view.points.back().z);
        highest = std::max(highest, view.points.back().z);
    }
    view.bottom = meanHeightNear(view.points, lowest, tolerance);
    view.top = meanHeightNear(view.points, highest, tolerance);
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const auto [a, b, c] = mesh.triangles[i];
        const auto [low, high] = std::minmax({view.points[a].z, view.points[b].z, view.points[c].z});
        FaceOrientation orientation = high - low <= tolerance ? FaceOrientation::Between : FaceOrientation::Oblique;
        if (low >= highest - tolerance) {
            orientation = FaceOrientation::Top;
        } else if (high <= lowest + tolerance) {
            orientation = FaceOrientation::Bottom;
        } else if (projectedWidth(view, mesh, i) <= tolerance) {
            orientation = FaceOrientation::Side;
        }
        view.orientations.push_back(orientation);
    }
    return view;
}

double projectedWidth(const AxisView& view, const TriangleMesh& mesh, std::size_t triangle) {
    const auto [a, b, c] = mesh.triangles[triangle];
    const Vec2 from = flat(view.points[a]), second = flat(view.points[b]), third = flat(view.points[c]);
    const double longest =
        std::max({glm::distance(from, second), glm::distance(second, third), glm::distance(third, from)});
    return longest == 0.0 ? 0.0 : std::abs(cross(second - from, third - from)) / longest;
}

double tiltDegrees(const AxisView& view, const TriangleMesh& mesh, std::size_t triangle) {
    const Vec3 normal = doubleArea(mesh, triangle);
    const double along = glm::dot(normal, view.frame.z);
    return std::atan2(std::abs(along), glm::length(normal - along * view.frame.z)) * (180.0 / 3.14159265358979323846);
}

std::vector<Ring> boundaryOf(const AxisView& view, const TriangleMesh& mesh, FaceOrientation orientation) {
    using Edge = std::array<std::uint32_t, 2>;
    std::set<Edge> edges;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (view.orientations[i] != orientation) continue;
        const auto& triangle = mesh.triangles[i];
        for (int k = 0; k < 3; ++k) {
            const Edge edge{triangle[k], triangle[(k + 1) % 3]};
            if (edges.erase({edge[1], edge[0]}) == 0) edges.insert(edge);
        }
    }
    std::vector<Ring> rings;
    while (!edges.empty()) {
        Ring& ring = rings.emplace_back();
        auto edge = edges.begin();
        while (edge != edges.end()) {
            const auto [from, to] = *edge;
            ring.push_back(flat(view.points[from]));
            edges.erase(edge);
            edge = edges.lower_bound({to, 0});
            if (edge != edges.end() && (*edge)[0] != to) edge = edges.end();
        }
    }
    return rings;
}

}  // namespace rubble
