#include "core/asset/finish/AssetFinish.h"

#include "core/asset/project/AssetShape.h"
#include "core/fracture/kinds/BrickCourses.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
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

constexpr double kLevel = 1e-6;          // of the sine of a slope
constexpr double kPlateThickness = 0.5;  // of the next longer side, at most

/// The axis that rises most where an asset of a size is placed in an orientation, as in FinishFrame. That of a sloping
/// plate, as of a roof, lies in it.
int upOf(Vec3 size, const Quat& orientation) {
    std::array<int, 3> axes{1, 0, 2};  // of equal ones the first
    const auto rise = [&](int axis) { return (orientation * axisVector(axis)).y; };
    std::ranges::stable_sort(axes, std::greater(), [&](int axis) { return std::round(std::abs(rise(axis)) / kLevel); });
    const bool isPlate = size[axes[0]] < kPlateThickness * std::min(size[axes[1]], size[axes[2]]);
    const int axis = isPlate && std::abs(rise(axes[1])) > kLevel ? axes[1] : axes[0];
    return rise(axis) < 0.0 ? -(axis + 1) : axis + 1;
}

}  // namespace

Quat placedOrientation(const Project& project, Id asset) {
    const auto placed = std::ranges::find(project.instances, asset, &Instance::asset);
    return placed != project.instances.end() ? placed->pose.orientation : Quat(1.0, 0.0, 0.0, 0.0);
}

int courseUp(const Asset& asset, const Quat& orientation) {
    return coursesOf(asset).isOn ? kUpright : upOf(sizeOf(asset), orientation);
}

AssetFinish assetFinish(const Asset& asset, const AssetMaterials& materials, const Quat& orientation) {
    const BrickCourseFrame courses = coursesOf(asset);
    return {.outside = asset.texture ? Finish::Plain : materials.own.finish,
            .inside = materials.inside.finish,
            .courses = courses,
            .frame = {.courseOrigin = Vec2(courses.origin),
                      .grainAxis = longestAxisOf(sizeOf(asset)),
                      .up = courseUp(asset, orientation)}};
}

SurfaceFinish surfaceFinish(const AssetFinish& finish, FinishSide side, Vec3 colour) {
    const FinishParameters& parameters =
        finishParameters(side == FinishSide::Outside ? finish.outside : finish.inside, side);
    return {withCourses(parameters, finish.courses), colour, finish.frame};
}

}  // namespace rubble
