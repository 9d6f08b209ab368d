#pragma once

#include "viewport/render/SceneBuffers.h"
#include "viewport/render/gl/RenderTarget.h"
#include "viewport/render/gl/ShaderProgram.h"

namespace rubble {

/// Draws transparent surfaces over an image. They are blended by weights, not sorted, so that the picture depends
/// neither on the order of bodies nor on the number of draw calls.
class TransparencyPass {
public:
    /// Errors: see ShaderProgram::create().
    static Result<TransparencyPass> create();

    /// The variants of transparent.frag: see SurfacePrograms.
    struct Programs {
        const ShaderProgram &plain, &finished, &textured;
    };
    /// Draws to the bound framebuffer of a size, whose depths occlude.
    void draw(const SceneBuffers& scene, ImageSize size, const Programs& programs, double focusDistance);

private:
    explicit TransparencyPass(ShaderProgram blend) : m_blend(std::move(blend)) {}
    void allocate(ImageSize size, int samples);

    ShaderProgram m_blend;
    ImageSize m_size{0, 0};
    int m_samples = 0;
    GlFramebuffer m_sums, m_resolved;  // the same if there is one sample a pixel
    GlRenderbuffer m_multisampleColours, m_multisampleWeights, m_depths;
    GlTexture m_colours, m_weights;
    GlTexture m_behind;  // the image without them, which they refract
    GlFramebuffer m_image;
    GlVertexArray m_emptyArray = GlVertexArray::create();
};

}  // namespace rubble
