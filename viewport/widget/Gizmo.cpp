#include "viewport/widget/Gizmo.h"

#include "core/geometry/predicates/SegmentDistance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace rubble {
namespace {

constexpr double kArrowLength = 92.0;                    // points, with its tip
constexpr double kRingRadius = 78.0;                     // points
constexpr double kNearSquare = 0.28, kFarSquare = 0.50;  // of an arrow's length
constexpr double kCentreRadius = 9.0;                    // points
constexpr double kGrabDistance = 8.0;                    // points, between the pointer and a line
constexpr double kMinArrow = 14.0;                       // points on screen: a shorter arrow is hidden
constexpr double kMinAngleSine = 0.06;                   // of the angle between a plane and the line of sight
constexpr int kRingSegments = 64;

constexpr std::array kAxes{Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, 1.0)};

/// Metres per point at the centre's depth.
double metresPerPoint(const GizmoView& view) {
    const double scale = metresPerPixel(view.camera, view.size);
    if (view.camera.projection == Projection::Orthographic) return scale;
    const double towardsEye = glm::dot(view.centre - view.camera.target, axesOf(view.camera).back);
    return scale * (view.camera.distance - towardsEye) / view.camera.distance;
}

Vec3 towardsEye(const GizmoView& view) {
    if (view.camera.projection == Projection::Orthographic) return axesOf(view.camera).back;
    return glm::normalize(eyeOf(view.camera) - view.centre);
}

/// Projects points of the world; empty if one lies behind the eye.
std::vector<Vec2> projected(const std::vector<Vec3>& points, const GizmoView& view) {
    std::vector<Vec2> line;
    for (const Vec3& point : points) {
        const std::optional<Vec2> pixel = pixelOf(view.camera, point, view.size);
        if (!pixel) return {};
        line.push_back(*pixel);
    }
    return line;
}

std::vector<Vec2> arrow(int axis, const GizmoView& view) {
    const double reach = kArrowLength * metresPerPoint(view);
    std::vector<Vec2> line = projected({view.centre, view.centre + reach * kAxes[axis]}, view);
    if (line.size() == 2 && glm::distance(line[0], line[1]) < kMinArrow) line.clear();
    return line;
}

std::vector<Vec2> square(int axis, const GizmoView& view) {
    if (std::abs(glm::dot(kAxes[axis], towardsEye(view))) < 2.0 * kMinAngleSine) return {};
    const double reach = kArrowLength * metresPerPoint(view);
    const Vec3 a = reach * kAxes[(axis + 1) % 3], b = reach * kAxes[(axis + 2) % 3];
    const auto at = [&](double alongA, double alongB) { return view.centre + alongA * a + alongB * b; };
    return projected({at(kNearSquare, kNearSquare), at(kFarSquare, kNearSquare), at(kFarSquare, kFarSquare),
                      at(kNearSquare, kFarSquare), at(kNearSquare, kNearSquare)},
                     view);
}

std::vector<Vec2> circle(Vec3 a, Vec3 b, double points, const GizmoView& view) {
    const double radius = points * metresPerPoint(view);
    std::vector<Vec3> ring;
    for (int k = 0; k <= kRingSegments; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / kRingSegments;
        ring.push_back(view.centre + radius * (std::cos(angle) * a + std::sin(angle) * b));
    }
    return projected(ring, view);
}

std::vector<Vec2> ring(int axis, const GizmoView& view) {
    if (std::abs(glm::dot(kAxes[axis], towardsEye(view))) < kMinAngleSine) return {};
    return circle(kAxes[(axis + 1) % 3], kAxes[(axis + 2) % 3], kRingRadius, view);
}

double distanceToLine(Vec2 point, const std::vector<Vec2>& line) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < line.size(); ++k)
        least = std::min(least, distanceToSegment(point, line[k - 1], line[k]));
    return least;
}

/// For a convex polygon of either orientation, its first point repeated at the end.
bool isWithin(Vec2 point, const std::vector<Vec2>& closed) {
    int left = 0, right = 0;
    for (std::size_t k = 1; k < closed.size(); ++k) {
        cross(closed[k] - closed[k - 1], point - closed[k - 1]) > 0.0 ? ++left : ++right;
    }
    return !closed.empty() && (left == 0 || right == 0);
}

/// The intersection of a ray and the plane through the centre.
std::optional<Vec3> onPlane(const Ray& ray, Vec3 centre, Vec3 normal) {
    const double pace = glm::dot(ray.direction, normal);
    if (std::abs(pace) < kMinAngleSine) return std::nullopt;
    const double distance = glm::dot(centre - ray.from, normal) / pace;
    if (distance < 0.0) return std::nullopt;
    return ray.at(distance);
}

/// The parameter of the point of an axis through the centre that is nearest to a ray.
std::optional<double> alongAxis(const Ray& ray, Vec3 centre, Vec3 axis) {
    const double cosine = glm::dot(ray.direction, axis);
    const double sine2 = 1.0 - cosine * cosine;
    if (sine2 < kMinAngleSine * kMinAngleSine) return std::nullopt;
    const Vec3 way = centre - ray.from;
    return (cosine * glm::dot(way, ray.direction) - glm::dot(way, axis)) / sine2;
}

/// The screen point of a ray.
std::optional<Vec2> screenPoint(const Ray& ray, const GizmoView& view) {
    return pixelOf(view.camera, ray.at(view.camera.distance), view.size);
}

/// The angle of the pointer around the centre on screen, counter-clockwise if the axis points towards the eye.
std::optional<double> screenRotationAngle(Vec3 axis, const GizmoView& view, const Ray& from, const Ray& to) {
    const std::optional<Vec2> centre = pixelOf(view.camera, view.centre, view.size);
    const std::optional<Vec2> before = screenPoint(from, view), after = screenPoint(to, view);
    if (!centre || !before || !after) return std::nullopt;
    const Vec2 a = *before - *centre, b = *after - *centre;
    const double downwards = std::atan2(cross(a, b), glm::dot(a, b));
    return glm::dot(axis, towardsEye(view)) < 0.0 ? downwards : -downwards;
}

}  // namespace

std::vector<GizmoHandle> handlesOf(GizmoMode mode) {
    using enum GizmoHandle;
    if (mode == GizmoMode::Rotate) return {RotateX, RotateZ, RotateY};
    return {MoveYz, MoveZx, MoveXy, MoveX, MoveZ, MoveY, MoveInView};
}

std::optional<int> axisOf(GizmoHandle handle) {
    switch (handle) {
        using enum GizmoHandle;
        case MoveX:
        case MoveYz:
        case RotateX: return 0;
        case MoveY:
        case MoveZx:
        case RotateY: return 1;
        case MoveZ:
        case MoveXy:
        case RotateZ: return 2;
        case MoveInView: break;
    }
    return std::nullopt;
}

bool isRotationHandle(GizmoHandle handle) {
    return handle == GizmoHandle::RotateX || handle == GizmoHandle::RotateY || handle == GizmoHandle::RotateZ;
}

bool isPlaneHandle(GizmoHandle handle) {
    return handle == GizmoHandle::MoveYz || handle == GizmoHandle::MoveZx || handle == GizmoHandle::MoveXy;
}

std::vector<Vec2> handleLine(GizmoHandle handle, const GizmoView& view) {
    if (metresPerPoint(view) <= 0.0) return {};
    const std::optional<int> axis = axisOf(handle);
    if (!axis) {
        const CameraAxes axes = axesOf(view.camera);
        return circle(axes.right, axes.up, kCentreRadius, view);
    }
    if (isRotationHandle(handle)) return ring(*axis, view);
    return isPlaneHandle(handle) ? square(*axis, view) : arrow(*axis, view);
}

std::optional<GizmoHandle> handleAt(Vec2 point, GizmoMode mode, const GizmoView& view) {
    std::optional<GizmoHandle> nearest;
    double least = kGrabDistance;
    for (const GizmoHandle handle : handlesOf(mode)) {
        const std::vector<Vec2> line = handleLine(handle, view);
        if (line.empty()) continue;
        const bool isArea = isPlaneHandle(handle) || handle == GizmoHandle::MoveInView;
        const double distance = isArea && isWithin(point, line) ? 0.0 : distanceToLine(point, line);
        const bool isNearer = handle == GizmoHandle::MoveInView ? distance == 0.0 : distance < least;
        if (!isNearer) continue;
        least = distance;
        nearest = handle;
    }
    return nearest;
}

std::optional<Vec3> translation(GizmoHandle handle, const GizmoView& view, const Ray& from, const Ray& to) {
    const std::optional<int> axis = axisOf(handle);
    if (axis && !isPlaneHandle(handle)) {
        const auto before = alongAxis(from, view.centre, kAxes[*axis]),
                   after = alongAxis(to, view.centre, kAxes[*axis]);
        if (!before || !after) return std::nullopt;
        return (*after - *before) * kAxes[*axis];
    }
    const Vec3 normal = axis ? kAxes[*axis] : axesOf(view.camera).back;
    const std::optional<Vec3> before = onPlane(from, view.centre, normal), after = onPlane(to, view.centre, normal);
    if (!before || !after) return std::nullopt;
    return *after - *before;
}

std::optional<double> rotationAngle(GizmoHandle handle, const GizmoView& view, const Ray& from, const Ray& to) {
    const std::optional<int> axis = axisOf(handle);
    if (!axis) return std::nullopt;
    const std::optional<Vec3> before = onPlane(from, view.centre, kAxes[*axis]);
    const std::optional<Vec3> after = onPlane(to, view.centre, kAxes[*axis]);
    if (!before || !after) return screenRotationAngle(kAxes[*axis], view, from, to);
    const Vec3 a = *before - view.centre, b = *after - view.centre;
    return std::atan2(glm::dot(glm::cross(a, b), kAxes[*axis]), glm::dot(a, b));
}

double snapped(double value, double step) { return step * std::round(value / step); }

}  // namespace rubble
