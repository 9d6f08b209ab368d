#include "viewport/Gizmo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace rubble {
namespace {

constexpr double kReach = 92.0;                          // points from the middle to an arrow's tip
constexpr double kRingReach = 78.0;                      // points
constexpr double kNearSquare = 0.28, kFarSquare = 0.50;  // of the reach
constexpr double kFreeReach = 9.0;                       // points: the circle in the middle
constexpr double kGrip = 8.0;                            // points beside a line that still take hold of it
constexpr double kShortest = 14.0;                       // points: a shorter arrow is seen end-on
constexpr double kFlattest = 0.06;                       // sine of the angle between a plane and the line of sight
constexpr int kRingSteps = 64;

constexpr std::array kAxes{Vec3(1.0, 0.0, 0.0), Vec3(0.0, 1.0, 0.0), Vec3(0.0, 0.0, 1.0)};

/// Metres in the middle's distance that a point of the picture spans.
double metresPerPoint(const GizmoView& view) {
    const double scale = metresPerPixel(view.camera, view.size);
    if (view.camera.projection == Projection::Orthographic) return scale;
    const double towardsEye = glm::dot(view.middle - view.camera.target, axesOf(view.camera).back);
    return scale * (view.camera.distance - towardsEye) / view.camera.distance;
}

Vec3 towardsEye(const GizmoView& view) {
    if (view.camera.projection == Projection::Orthographic) return axesOf(view.camera).back;
    return glm::normalize(eyeOf(view.camera) - view.middle);
}

/// The points of the world in the picture; none where one lies behind the eye.
std::vector<Vec2> seen(const std::vector<Vec3>& points, const GizmoView& view) {
    std::vector<Vec2> line;
    for (const Vec3& point : points) {
        const std::optional<Vec2> pixel = pixelOf(view.camera, point, view.size);
        if (!pixel) return {};
        line.push_back(*pixel);
    }
    return line;
}

std::vector<Vec2> arrow(int axis, const GizmoView& view) {
    const double reach = kReach * metresPerPoint(view);
    std::vector<Vec2> line = seen({view.middle, view.middle + reach * kAxes[axis]}, view);
    if (line.size() == 2 && glm::distance(line[0], line[1]) < kShortest) line.clear();
    return line;
}

std::vector<Vec2> square(int axis, const GizmoView& view) {
    if (std::abs(glm::dot(kAxes[axis], towardsEye(view))) < 2.0 * kFlattest) return {};
    const double reach = kReach * metresPerPoint(view);
    const Vec3 a = reach * kAxes[(axis + 1) % 3], b = reach * kAxes[(axis + 2) % 3];
    const auto at = [&](double alongA, double alongB) { return view.middle + alongA * a + alongB * b; };
    return seen({at(kNearSquare, kNearSquare), at(kFarSquare, kNearSquare), at(kFarSquare, kFarSquare),
                 at(kNearSquare, kFarSquare), at(kNearSquare, kNearSquare)},
                view);
}

std::vector<Vec2> circle(Vec3 a, Vec3 b, double points, const GizmoView& view) {
    const double radius = points * metresPerPoint(view);
    std::vector<Vec3> ring;
    for (int k = 0; k <= kRingSteps; ++k) {
        const double angle = 2.0 * std::numbers::pi * k / kRingSteps;
        ring.push_back(view.middle + radius * (std::cos(angle) * a + std::sin(angle) * b));
    }
    return seen(ring, view);
}

std::vector<Vec2> ring(int axis, const GizmoView& view) {
    if (std::abs(glm::dot(kAxes[axis], towardsEye(view))) < kFlattest) return {};
    return circle(kAxes[(axis + 1) % 3], kAxes[(axis + 2) % 3], kRingReach, view);
}

double distanceToSegment(Vec2 point, Vec2 a, Vec2 b) {
    const Vec2 along = b - a;
    const double length2 = glm::dot(along, along);
    const double share = length2 > 0.0 ? std::clamp(glm::dot(point - a, along) / length2, 0.0, 1.0) : 0.0;
    return glm::distance(point, a + share * along);
}

double distanceToLine(Vec2 point, const std::vector<Vec2>& line) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < line.size(); ++k)
        least = std::min(least, distanceToSegment(point, line[k - 1], line[k]));
    return least;
}

/// Of a ring of corners that turns one way or the other.
bool isWithin(Vec2 point, const std::vector<Vec2>& closed) {
    int left = 0, right = 0;
    for (std::size_t k = 1; k < closed.size(); ++k) {
        cross(closed[k] - closed[k - 1], point - closed[k - 1]) > 0.0 ? ++left : ++right;
    }
    return !closed.empty() && (left == 0 || right == 0);
}

/// Where a ray meets the plane through the middle.
std::optional<Vec3> onPlane(const Ray& ray, Vec3 middle, Vec3 normal) {
    const double pace = glm::dot(ray.direction, normal);
    if (std::abs(pace) < kFlattest) return std::nullopt;
    const double distance = glm::dot(middle - ray.from, normal) / pace;
    if (distance < 0.0) return std::nullopt;
    return ray.at(distance);
}

/// How far along an axis through the middle a ray comes nearest to it.
std::optional<double> alongAxis(const Ray& ray, Vec3 middle, Vec3 axis) {
    const double cosine = glm::dot(ray.direction, axis);
    const double sine2 = 1.0 - cosine * cosine;
    if (sine2 < kFlattest * kFlattest) return std::nullopt;
    const Vec3 way = middle - ray.from;
    return (cosine * glm::dot(way, ray.direction) - glm::dot(way, axis)) / sine2;
}

/// Where a ray is seen that goes through a point of the picture.
std::optional<Vec2> pointOf(const Ray& ray, const GizmoView& view) {
    return pixelOf(view.camera, ray.at(view.camera.distance), view.size);
}

/// The angle by which the pointer went around the middle in the picture, counter-clockwise for an axis towards the eye.
std::optional<double> turnedInPicture(Vec3 axis, const GizmoView& view, const Ray& from, const Ray& to) {
    const std::optional<Vec2> middle = pixelOf(view.camera, view.middle, view.size);
    const std::optional<Vec2> before = pointOf(from, view), after = pointOf(to, view);
    if (!middle || !before || !after) return std::nullopt;
    const Vec2 a = *before - *middle, b = *after - *middle;
    const double downwards = std::atan2(cross(a, b), glm::dot(a, b));
    return glm::dot(axis, towardsEye(view)) < 0.0 ? downwards : -downwards;
}

}  // namespace

std::vector<GizmoHandle> handlesOf(GizmoMode mode) {
    using enum GizmoHandle;
    if (mode == GizmoMode::Turn) return {TurnX, TurnZ, TurnY};
    return {MoveYz, MoveZx, MoveXy, MoveX, MoveZ, MoveY, MoveFreely};
}

std::optional<int> axisOf(GizmoHandle handle) {
    switch (handle) {
        using enum GizmoHandle;
        case MoveX:
        case MoveYz:
        case TurnX: return 0;
        case MoveY:
        case MoveZx:
        case TurnY: return 1;
        case MoveZ:
        case MoveXy:
        case TurnZ: return 2;
        case MoveFreely: break;
    }
    return std::nullopt;
}

bool isTurn(GizmoHandle handle) {
    return handle == GizmoHandle::TurnX || handle == GizmoHandle::TurnY || handle == GizmoHandle::TurnZ;
}

bool isPlane(GizmoHandle handle) {
    return handle == GizmoHandle::MoveYz || handle == GizmoHandle::MoveZx || handle == GizmoHandle::MoveXy;
}

std::vector<Vec2> lineOf(GizmoHandle handle, const GizmoView& view) {
    if (metresPerPoint(view) <= 0.0) return {};
    const std::optional<int> axis = axisOf(handle);
    if (!axis) {
        const CameraAxes axes = axesOf(view.camera);
        return circle(axes.right, axes.up, kFreeReach, view);
    }
    if (isTurn(handle)) return ring(*axis, view);
    return isPlane(handle) ? square(*axis, view) : arrow(*axis, view);
}

std::optional<GizmoHandle> handleAt(Vec2 point, GizmoMode mode, const GizmoView& view) {
    std::optional<GizmoHandle> nearest;
    double least = kGrip;
    for (const GizmoHandle handle : handlesOf(mode)) {
        const std::vector<Vec2> line = lineOf(handle, view);
        if (line.empty()) continue;
        const bool isArea = isPlane(handle) || handle == GizmoHandle::MoveFreely;
        const double distance = isArea && isWithin(point, line) ? 0.0 : distanceToLine(point, line);
        const bool isNearer = handle == GizmoHandle::MoveFreely ? distance == 0.0 : distance < least;
        if (!isNearer) continue;
        least = distance;
        nearest = handle;
    }
    return nearest;
}

std::optional<Vec3> movedBy(GizmoHandle handle, const GizmoView& view, const Ray& from, const Ray& to) {
    const std::optional<int> axis = axisOf(handle);
    if (axis && !isPlane(handle)) {
        const auto before = alongAxis(from, view.middle, kAxes[*axis]),
                   after = alongAxis(to, view.middle, kAxes[*axis]);
        if (!before || !after) return std::nullopt;
        return (*after - *before) * kAxes[*axis];
    }
    const Vec3 normal = axis ? kAxes[*axis] : axesOf(view.camera).back;
    const std::optional<Vec3> before = onPlane(from, view.middle, normal), after = onPlane(to, view.middle, normal);
    if (!before || !after) return std::nullopt;
    return *after - *before;
}

std::optional<double> turnedBy(GizmoHandle handle, const GizmoView& view, const Ray& from, const Ray& to) {
    const std::optional<int> axis = axisOf(handle);
    if (!axis) return std::nullopt;
    const std::optional<Vec3> before = onPlane(from, view.middle, kAxes[*axis]);
    const std::optional<Vec3> after = onPlane(to, view.middle, kAxes[*axis]);
    if (!before || !after) return turnedInPicture(kAxes[*axis], view, from, to);
    const Vec3 a = *before - view.middle, b = *after - view.middle;
    return std::atan2(glm::dot(glm::cross(a, b), kAxes[*axis]), glm::dot(a, b));
}

double snapped(double value, double step) { return step * std::round(value / step); }

}  // namespace rubble
