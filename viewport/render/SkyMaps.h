#pragma once

#include "viewport/render/ShadowMap.h"

#include <glm/mat4x4.hpp>

#include <span>
#include <vector>

namespace rubble {

/// Shadow maps of many directions of the sky: how much of it reaches a point.
class SkyMaps {
public:
    static constexpr int kMost = 32;

    /// `width`: the number of texels on each side of a map.
    explicit SkyMaps(int width);

    /// The scene has changed: all maps are outdated.
    void invalidate() { m_outdated = m_maps.size(); }
    /// Renders the maps of new directions, or of the same ones at most `most` of those that are outdated, in turns.
    void draw(const SceneBuffers& scene, const RenderPrograms& programs, std::span<const Vec3> directions,
              const LightRegion& region, int most);
    bool isCurrent() const { return m_outdated == 0; }
    /// Binds the textures and the uniform block of sky.glsl.
    void bind(Vec3 origin) const;

private:
    struct Map {
        Vec3 direction;
        glm::dmat4 textureFromWorld{1.0};
    };
    void allocate();
    void render(int layer, const SceneBuffers& scene, const RenderPrograms& programs);

    int m_width;
    GlTexture m_depths;  // a layer for each map
    std::vector<GlFramebuffer> m_framebuffers;
    GlBuffer m_uniforms;
    LightRegion m_region;
    std::vector<Map> m_maps;
    int m_rendered = 0;          // the first ones
    std::size_t m_outdated = 0;  // how many
    int m_next = 0;              // the one to render next
};

}  // namespace rubble
