#pragma once

#include "viewport/render/Lighting.h"
#include "viewport/render/Renderer.h"

#include <glm/mat4x4.hpp>

namespace rubble {

/// The uniform block Frame of frame.glsl, where each field is documented.
struct FrameBlock {
    glm::mat4 clipFromScene, keyFromScene, skyFromScene;
    glm::vec4 eye, back, keyDirection, skyDirection, skyLight, groundLight;
    glm::vec4 backgroundTop, backgroundBottom, grid, ground, shaded, spacing, accent, edges;
    glm::vec4 right, up, depth, zenith, horizon, soil, viewport;
    glm::uvec4 hovered;
};

/// All fields but the shadow matrices. `bounds`: the bounds of the scene; `sample`: given if the image is one sample of
/// many.
FrameBlock frameBlock(const RenderView& view, const RenderScene& scene, const Box3& bounds,
                      const std::optional<LightSample>& sample);

/// The scene's origin modulo the grid's coarse step, so that the grid stays precise far from zero.
glm::vec3 gridOrigin(const FrameBlock& frame, const RenderScene& scene);

}  // namespace rubble
