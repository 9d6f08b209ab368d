#include "core/asset/finish/AssetFinish.h"

#include "core/asset/project/AssetShape.h"
#include "core/fracture/kinds/BrickCourses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <variant>

namespace rubble {
namespace {

constexpr float kHairline = 0.004f;  // m: joints of bricks without mortar

/// The courses of the first brick layer that is on.
BrickCourseFrame coursesOf(const Asset& asset) {
    for (const PatternLayer& layer : asset.pattern.layers) {
        const auto* bricks = std::get_if<BrickBond>(&layer.parameters);
        if (bricks == nullptr || !layer.isOn) continue;
        const BrickCourses courses(*bricks);
        const auto lengths = [&](int course) {
            return std::array{static_cast<float>(courses.courseOf(course).cells[0]),
                              static_cast<float>(courses.courseOf(course).cells[1])};
        };
        return {.isOn = true,
                .origin = glm::vec2(bricks->origin),
                .form = {.height = static_cast<float>(courses.bottom(1) - courses.bottom(0)),
                         .even = lengths(0),
                         .odd = lengths(1),
                         .oddStart = static_cast<float>(courses.courseOf(1).start)},
                .jointWidth = bricks->mortar > 0.0 ? 0.0f : kHairline};
    }
    return {};
}

int longestAxisOf(Vec3 size) { return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2; }

Vec3 axisVector(int axis) {
    Vec3 vector(0.0);
    vector[axis] = 1.0;
    return vector;
}

/// The frame of an asset of a size that is placed in an orientation. As a roof, it is a plate whose courses run along
/// the more horizontal side and rise along the other; of two horizontal sides, along the longer one.
FinishFrame frameOf(const BrickCourseFrame& courses, Vec3 size, const Quat& orientation) {
    constexpr double kLevel = 1e-6;  // of the sine of a slope
    const int thin = size.z <= size.x && size.z <= size.y ? 2 : size.y <= size.x ? 1 : 0;
    int along = (thin + 1) % 3, across = (thin + 2) % 3;
    const auto rise = [&](int axis) { return (orientation * axisVector(axis)).y; };
    const double difference = std::abs(rise(along)) - std::abs(rise(across));
    if (difference > kLevel || (difference > -kLevel && size[across] > size[along])) std::swap(along, across);
    return {.courseOrigin = Vec2(courses.origin),
            .grainAxis = longestAxisOf(size),
            .roofAxis = along,
            .isRoofUpsideDown = rise(across) < -kLevel};
}

}  // namespace

Quat placedOrientation(const Project& project, Id asset) {
    const auto placed = std::ranges::find(project.instances, asset, &Instance::asset);
    return placed != project.instances.end() ? placed->pose.orientation : Quat(1.0, 0.0, 0.0, 0.0);
}

AssetFinish assetFinish(const Asset& asset, const AssetMaterials& materials, const Quat& orientation) {
    const BrickCourseFrame courses = coursesOf(asset);
    return {.outside = asset.texture ? Finish::Plain : materials.own.finish,
            .inside = materials.inside.finish,
            .courses = courses,
            .frame = frameOf(courses, sizeOf(asset), orientation)};
}

SurfaceFinish surfaceFinish(const AssetFinish& finish, FinishSide side, Vec3 colour) {
    const FinishParameters& parameters =
        finishParameters(side == FinishSide::Outside ? finish.outside : finish.inside, side);
    return {withCourses(parameters, finish.courses), colour, finish.frame};
}

}  // namespace rubble
