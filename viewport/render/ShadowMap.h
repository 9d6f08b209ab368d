#pragma once

#include "viewport/render/GlObjects.h"
#include "viewport/render/SceneBuffers.h"
#include "viewport/render/ShaderProgram.h"

namespace rubble {

/// How far light from one direction reaches.
class ShadowMap {
public:
    explicit ShadowMap(int width);  // texels, along both sides

    /// Draws a scene as seen from far away along `direction` (towards the light), around a box in the world.
    void draw(const SceneBuffers& scene, const ShaderProgram& depthProgram, Vec3 direction, const Box3& bounds);
    void bind(TextureUnit unit) const;

    /// From the scene to the map: texture coordinates and depth in [0, 1].
    const glm::mat4& placeFromScene() const { return m_placeFromScene; }

private:
    int m_width;
    GlTexture m_depths;
    GlFramebuffer m_framebuffer;
    glm::mat4 m_placeFromScene{1.0f};
};

}  // namespace rubble
