#pragma once

#include "viewport/render/GlObjects.h"
#include "viewport/render/RenderPrograms.h"
#include "viewport/render/SceneBuffers.h"

namespace rubble {

/// The shadow map of a directional light.
class ShadowMap {
public:
    /// `width`: the number of texels on each side.
    explicit ShadowMap(int width);

    /// Renders the depths of a scene, seen from `direction` (towards the light). Of transparent surfaces only a part of
    /// the texels, in a pattern with an index.
    void draw(const SceneBuffers& scene, const RenderPrograms& programs, Vec3 direction, const SceneSummary& summary,
              int pattern);
    void bind(TextureUnit unit) const;

    /// Transforms scene positions to texture coordinates and depth in [0, 1].
    const glm::mat4& textureFromScene() const { return m_textureFromScene; }

private:
    int m_width;
    GlTexture m_depths;
    GlFramebuffer m_framebuffer;
    glm::mat4 m_textureFromScene{1.0f};
};

}  // namespace rubble
