#include "viewport/scene/Camera.h"

#include "core/base/math/Trigonometry.h"
#include "core/geometry/line/SegmentClip.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubble {
namespace {

constexpr double kQuarterTurn = std::numbers::pi / 2.0;
constexpr double kNearest = 1e-4;     // m; nearer, rounding to single precision becomes visible
constexpr double kFarthest = 1e6;     // m
constexpr double kMargin = 1.08;      // the framed box takes 1 / kMargin of the image
constexpr double kMaxCovered = 0.75;  // of the height of an image, by strips
constexpr double kMinNear = 2e-4;     // near plane ÷ far plane at least: limits the error of the depth buffer
// Before the eye, in distances of the camera, at least. A point at the eye would be infinitely far beside the image.
constexpr double kMinDepth = 1e-6;
constexpr double kMinLineDepth = 1e-3;

double halfTangent(const Camera& camera) { return sine(camera.fieldOfView / 2.0) / cosine(camera.fieldOfView / 2.0); }

double wrapped(double angle) { return angle - kFullTurn * std::round(angle / kFullTurn); }

/// The depths of a box's nearest and farthest corners along the view direction.
std::array<double, 2> depthsOf(const Box3& box, const Camera& camera) {
    const Vec3 eye = eyeOf(camera), back = axesOf(camera).back;
    double nearest = 1e308, farthest = -1e308;
    for (int corner = 0; corner < 8; ++corner) {
        const double depth = glm::dot(eye - box.corner(corner), back);
        nearest = std::min(nearest, depth);
        farthest = std::max(farthest, depth);
    }
    return {nearest, farthest};
}

glm::dmat4 viewMatrix(const Camera& camera, Vec3 origin) {
    const CameraAxes axes = axesOf(camera);
    const Vec3 eye = eyeOf(camera) - origin;
    glm::dmat4 view(1.0);
    for (int k = 0; k < 3; ++k) {
        view[k][0] = axes.right[k];
        view[k][1] = axes.up[k];
        view[k][2] = axes.back[k];
    }
    view[3] = {-glm::dot(axes.right, eye), -glm::dot(axes.up, eye), -glm::dot(axes.back, eye), 1.0};
    return view;
}

}  // namespace

Camera alignedTo(Camera camera, StandardView view) {
    static constexpr std::array<std::array<double, 2>, 7> kAngles = {{{0.0, 0.0},
                                                                      {std::numbers::pi, 0.0},
                                                                      {kQuarterTurn, 0.0},
                                                                      {-kQuarterTurn, 0.0},
                                                                      {0.0, kQuarterTurn},
                                                                      {0.0, -kQuarterTurn},
                                                                      {std::numbers::pi / 4.0, 0.6154797086703873}}};
    const auto& [azimuth, elevation] = kAngles[static_cast<std::size_t>(view)];
    camera.azimuth = azimuth;
    camera.elevation = elevation;
    return camera;
}

CameraAxes axesOf(const Camera& camera) {
    const double sinA = sine(camera.azimuth), cosA = cosine(camera.azimuth);
    const double sinE = sine(camera.elevation), cosE = cosine(camera.elevation);
    return {{cosA, 0.0, -sinA}, {-sinE * sinA, cosE, -sinE * cosA}, {cosE * sinA, sinE, cosE * cosA}};
}

Vec3 eyeOf(const Camera& camera) { return camera.target + camera.distance * axesOf(camera).back; }

Ray rayThrough(const Camera& camera, Vec2 pixel, ImageSize size) {
    const CameraAxes axes = axesOf(camera);
    const Vec2 fromCentre(pixel.x - 0.5 * size.width, 0.5 * size.height - pixel.y);
    const Vec3 aside = metresPerPixel(camera, size) * (fromCentre.x * axes.right + fromCentre.y * axes.up);
    const Vec3 eye = eyeOf(camera);
    if (camera.projection == Projection::Orthographic) return {eye + aside, -axes.back};
    return {eye, glm::normalize(camera.target + aside - eye)};
}

std::optional<Vec2> pixelOf(const Camera& camera, Vec3 point, ImageSize size) {
    const CameraAxes axes = axesOf(camera);
    const Vec3 arm = point - camera.target;
    double scale = 1.0 / metresPerPixel(camera, size);
    if (camera.projection == Projection::Perspective) {
        const double depth = camera.distance - glm::dot(arm, axes.back);
        if (depth <= kMinDepth * camera.distance) return std::nullopt;
        scale *= camera.distance / depth;
    }
    return Vec2(0.5 * size.width + scale * glm::dot(arm, axes.right),
                0.5 * size.height - scale * glm::dot(arm, axes.up));
}

std::optional<std::array<Vec2, 2>> pixelsOf(const Camera& camera, Vec3 from, Vec3 to, ImageSize size) {
    if (camera.projection == Projection::Perspective) {
        const Vec3 back = axesOf(camera).back;
        const double least = kMinLineDepth * camera.distance;
        const double first = camera.distance - glm::dot(from - camera.target, back);
        const double last = camera.distance - glm::dot(to - camera.target, back);
        if (first < least && last < least) return std::nullopt;
        if (first < least) from = glm::mix(from, to, (least - first) / (last - first));
        if (last < least) to = glm::mix(to, from, (least - last) / (first - last));
    }
    const std::optional<Vec2> start = pixelOf(camera, from, size), end = pixelOf(camera, to, size);
    if (!start || !end) return std::nullopt;
    const Vec2 corner(size.width, size.height);
    return clippedTo({-corner, 2.0 * corner}, *start, *end);
}

double metresPerPixel(const Camera& camera, ImageSize size) {
    return 2.0 * camera.distance * halfTangent(camera) / static_cast<double>(size.height);
}

Camera orbited(Camera camera, double azimuth, double elevation) {
    camera.azimuth = wrapped(camera.azimuth + azimuth);
    camera.elevation = std::clamp(camera.elevation + elevation, -kQuarterTurn, kQuarterTurn);
    return camera;
}

Camera panned(Camera camera, Vec2 pixels, ImageSize size) {
    const CameraAxes axes = axesOf(camera);
    camera.target += metresPerPixel(camera, size) * (pixels.y * axes.up - pixels.x * axes.right);
    return camera;
}

Camera dollied(Camera camera, double factor, Vec2 anchor, ImageSize size) {
    const double distance = std::clamp(camera.distance * factor, kNearest, kFarthest);
    const Vec2 fromCentre = anchor - 0.5 * Vec2(size.width, size.height);
    const double kept = 1.0 - distance / camera.distance;
    camera = panned(camera, -kept * fromCentre, size);
    camera.distance = distance;
    return camera;
}

/// In units of half the height of the image, the box is centred at -`above` and takes `free`. A corner at the height y
/// and t before the target's plane is within if |y - above * tangent * t| <= free * tangent * (distance - t).
Camera framing(Camera camera, const Box3& box, ImageSize size, const ImageStrips& strips) {
    if (box.isEmpty()) return camera;
    const double wanted = strips.top + strips.bottom, covered = std::min(wanted, kMaxCovered * size.height);
    const double above = wanted > 0.0 ? covered / wanted * (strips.top - strips.bottom) / size.height : 0.0;
    const double free = 1.0 - covered / size.height;
    const CameraAxes axes = axesOf(camera);
    const double tangent = halfTangent(camera);
    double distance = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 arm = box.corner(corner) - box.centre();
        const double towards = camera.projection == Projection::Perspective ? glm::dot(arm, axes.back) : 0.0;
        const double across = std::max(std::abs(glm::dot(arm, axes.right)) / size.aspect(),
                                       std::abs(glm::dot(arm, axes.up) - above * tangent * towards) / free);
        distance = std::max(distance, kMargin * across / tangent + towards);
    }
    camera.distance = std::clamp(distance, kNearest, kFarthest);
    camera.target = box.centre() + above * tangent * camera.distance * axes.up;
    return camera;
}

Camera interpolated(const Camera& from, const Camera& to, double fraction) {
    Camera camera = to;
    camera.target = from.target + fraction * (to.target - from.target);
    camera.azimuth = from.azimuth + fraction * wrapped(to.azimuth - from.azimuth);
    camera.elevation = from.elevation + fraction * (to.elevation - from.elevation);
    camera.distance = from.distance + fraction * (to.distance - from.distance);
    camera.fieldOfView = from.fieldOfView + fraction * (to.fieldOfView - from.fieldOfView);
    return fraction >= 1.0 ? to : camera;
}

CameraMatrices matricesOf(const Camera& camera, ImageSize size, Vec3 origin, const Box3& bounds) {
    const double halfHeight = camera.distance * halfTangent(camera);
    const auto [nearest, farthest] =
        bounds.isEmpty() ? std::array{camera.distance, camera.distance} : depthsOf(bounds, camera);
    const double slack = 0.01 * std::max(farthest - nearest, camera.distance);
    CameraMatrices matrices{viewMatrix(camera, origin), {}};
    if (camera.projection == Projection::Orthographic) {
        matrices.projection = glm::ortho(-halfHeight * size.aspect(), halfHeight * size.aspect(), -halfHeight,
                                         halfHeight, nearest - slack, farthest + slack);
    } else {
        const double far = std::max(farthest, camera.distance) + slack;
        const double near = std::clamp(nearest - slack, kMinNear * far, 0.5 * camera.distance);
        matrices.projection = glm::perspective(camera.fieldOfView, size.aspect(), near, far);
    }
    return matrices;
}

}  // namespace rubble
