#pragma once

#include "core/geometry/predicates/Vec.h"

#include <glm/vec3.hpp>

#include <functional>
#include <vector>

namespace rubble {

/// What surfaces of several roughnesses reflect: the radiance around each direction in the mean over their lobe. An
/// octahedral map for each roughness, with a border of one texel, so that bilinear filtering has no seams.
/// Sources: Engelhardt, Dachsbacher, "Octahedron environment maps", 2008; Karis, "Real shading in Unreal Engine 4",
/// 2013.
struct ReflectionMap {
    static constexpr int kWidth = 64;           // texels on each side without the border
    static constexpr int kLevels = 6;           // roughness 0, 0.2 ... 1
    static constexpr int kStored = kWidth + 2;  // texels on each side
    std::vector<glm::vec3> texels;              // level by level, row by row
    bool operator==(const ReflectionMap&) const = default;
};

/// The map of a radiance, whose argument has length 1.
ReflectionMap reflectionMap(const std::function<Vec3(Vec3)>& radiance);

/// The place of a direction in a level: in [0, 1] with the border.
Vec2 placeInReflections(Vec3 direction);
/// The direction of a place, of length 1; places on the border are folded over.
Vec3 directionInReflections(Vec2 place);
/// The value for a direction and a roughness in [0, 1], filtered as by the shaders.
Vec3 reflected(const ReflectionMap& map, Vec3 direction, double roughness);

}  // namespace rubble
