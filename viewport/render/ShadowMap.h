#pragma once

#include "viewport/render/RenderPrograms.h"
#include "viewport/render/SceneBuffers.h"
#include "viewport/render/gl/GlObjects.h"
#include "viewport/render/light/Lighting.h"

namespace rubble {

/// The view projection of a directional light: an orthographic cube around a region of the world.
glm::dmat4 clipFromWorldOfLight(Vec3 direction, const LightRegion& region);
/// The same, to texture coordinates and depth in [0, 1].
glm::dmat4 textureFromWorldOfLight(Vec3 direction, const LightRegion& region);

/// The shadow map of a directional light: the depths of opaque bodies, and what transparent ones leave of the light.
class ShadowMap {
public:
    /// `width`: the number of texels on each side.
    explicit ShadowMap(int width);

    /// Renders the bodies of a scene in a region, seen from `direction` (towards the light).
    void draw(const SceneBuffers& scene, const RenderPrograms& programs, Vec3 direction, const LightRegion& region,
              bool hasTransparent);
    /// Binds the textures of key_shadow.glsl.
    void bind() const;

    /// Transforms scene positions to texture coordinates and depth in [0, 1].
    const glm::mat4& textureFromScene() const { return m_textureFromScene; }

private:
    void drawGlass(const SceneBuffers& scene, const RenderPrograms& programs, const glm::mat4& clip);

    int m_width;
    GlTexture m_depths, m_glass, m_glassDepths;  // the latter two once a body is transparent
    GlFramebuffer m_framebuffer, m_glassFramebuffer;
    GlSampler m_uncompared;  // reads depths
    glm::mat4 m_textureFromScene{1.0f};
};

/// State for rendering a shadow map; the destructor restores it.
class ShadowState {
public:
    ShadowState();
    ~ShadowState();
    ShadowState(const ShadowState&) = delete;
    ShadowState& operator=(const ShadowState&) = delete;
};

}  // namespace rubble
