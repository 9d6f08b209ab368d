#include "core/asset/finish/AssetFinish.h"

#include "core/asset/project/AssetShape.h"
#include "core/fracture/kinds/BrickBond.h"

#include <variant>

namespace rubble {
namespace {

constexpr float kHairline = 0.004f;  // m: joints of bricks without mortar

/// The courses of the first brick layer that is on, if each course has bricks of one size.
BrickCourseFrame coursesOf(const Asset& asset) {
    for (const PatternLayer& layer : asset.pattern.layers) {
        const auto* bricks = std::get_if<BrickBond>(&layer.parameters);
        if (bricks == nullptr || !layer.isOn) continue;
        const bool isMixed = bricks->bond == BondKind::English || bricks->bond == BondKind::Flemish;
        const double length = bricks->bond == BondKind::Header ? bricks->width : bricks->length;
        return {.isOn = true,
                .origin = glm::vec2(bricks->origin),
                .size = isMixed ? glm::vec2(1e3) : glm::vec2(Vec2(length, bricks->height) + bricks->mortar),
                .shift = bricks->bond == BondKind::Stack ? 0.0f : 0.5f,
                .jointWidth = bricks->mortar > 0.0 || isMixed ? 0.0f : kHairline};
    }
    return {};
}

int longestAxisOf(Vec3 size) { return size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2; }

}  // namespace

AssetFinish assetFinish(const Asset& asset, const AssetMaterials& materials) {
    return {.outside = asset.texture ? Finish::Plain : materials.own.finish,
            .inside = materials.inside.finish,
            .courses = coursesOf(asset),
            .grainAxis = longestAxisOf(sizeOf(asset))};
}

SurfaceFinish surfaceFinish(const AssetFinish& finish, FinishSide side, Vec3 colour) {
    const FinishParameters& parameters =
        finishParameters(side == FinishSide::Outside ? finish.outside : finish.inside, side);
    return {withCourses(parameters, finish.courses), colour, Vec2(finish.courses.origin), finish.grainAxis};
}

}  // namespace rubble
