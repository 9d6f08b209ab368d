#pragma once

#include "viewport/render/Lighting.h"
#include "viewport/render/Renderer.h"

#include <glm/mat4x4.hpp>

#include <array>

namespace rubble {

/// The block Frame of frame.glsl, where each field is explained.
struct FrameBlock {
    glm::mat4 clipFromScene, keyFromScene, skyFromScene;
    glm::vec4 eye, back, keyDirection, skyDirection, skyLight, groundLight;
    glm::vec4 backgroundTop, backgroundBottom, grid, ground, shaded, spacing, accent, edges;
    glm::vec4 right, up, depth, zenith, horizon, soil, picture;
    glm::vec4 missile, missileWay, strike;
    std::array<glm::vec4, 6> heatRamp;
    glm::uvec4 hovered;
};

/// What does not depend on shadows of a picture of a scene, whose bounds are given; `sample` where it is one of many.
FrameBlock frameBlock(const PictureView& view, const RenderScene& scene, const Box3& bounds,
                      const std::optional<LightSample>& sample);

/// Where the grid's zero lies as seen from a scene's origin, less whole steps: keeps its digits far from zero.
glm::vec3 gridOrigin(const FrameBlock& frame, const RenderScene& scene);

}  // namespace rubble
