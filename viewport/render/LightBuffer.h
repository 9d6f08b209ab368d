#pragma once

#include "viewport/render/RenderPrograms.h"
#include "viewport/render/SceneBuffers.h"
#include "viewport/render/gl/RenderTarget.h"

namespace rubble {

/// The light that reaches the nearest surfaces of an image, at a lower resolution: computed once for a few pixels, and
/// smoothed within surfaces. See light.glsl.
class LightBuffer {
public:
    /// Pixels of an image for a texel, in each direction.
    static constexpr int kPixels = 2;

    /// Fills it for an image of a size. The frame's uniforms are set, the shadow maps bound.
    void draw(const SceneBuffers& scene, const RenderPrograms& programs, ImageSize size);
    /// Binds it to TextureUnit::LightBuffer.
    void bind() const;

private:
    void allocate(ImageSize size);

    ImageSize m_size{0, 0};
    GlFramebuffer m_surfaces;
    GlTexture m_normals, m_depths;
    struct Target {
        GlFramebuffer framebuffer;
        GlTexture texels;
    } m_raw, m_smooth;
    GlVertexArray m_emptyArray = GlVertexArray::create();
};

}  // namespace rubble
