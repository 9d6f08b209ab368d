#pragma once

#include "viewport/render/Renderer.h"
#include "viewport/render/light/Lighting.h"

#include <glm/mat4x4.hpp>

namespace rubble {

/// The uniform block Frame of frame.glsl, where each field is documented.
struct FrameBlock {
    glm::mat4 clipFromScene, keyFromScene;
    glm::vec4 eye, back, keyDirection, keyLight, skyLight[7], groundLight;
    glm::vec4 backgroundTop, backgroundBottom, grid, ground, spacing, gridOrigin, accent, edges;
    glm::vec4 right, up, depth, zenith, horizon, glow, soil, groundKey, viewport, jitter;
    glm::uvec4 hovered;
};

/// All fields but the shadow matrix.
FrameBlock frameBlock(const RenderView& view, const RenderScene& scene, const SceneSummary& summary,
                      const SkyLight& light, const LightSample& sample);

}  // namespace rubble
