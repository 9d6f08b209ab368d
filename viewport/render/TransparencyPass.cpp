#include "viewport/render/TransparencyPass.h"

#include <epoxy/gl.h>

namespace rubble {
namespace {

constexpr GLenum kColourTargets = GL_COLOR_ATTACHMENT0, kWeights = GL_COLOR_ATTACHMENT1;
constexpr GLenum kBoth[] = {kColourTargets, kWeights};

GlTexture texture(ImageSize size, GLenum format, GLenum components) {
    GlTexture made = GlTexture::create();
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(TextureUnit::Source));
    glBindTexture(GL_TEXTURE_2D, made.id());
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), size.width, size.height, 0, components, GL_FLOAT,
                 nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return made;
}

/// Attaches a renderbuffer to the bound framebuffer.
GlRenderbuffer attached(GLenum attachment, ImageSize size, GLenum format, int samples) {
    GlRenderbuffer made = GlRenderbuffer::create();
    glBindRenderbuffer(GL_RENDERBUFFER, made.id());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size.width, size.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, made.id());
    return made;
}

void copy(std::uint32_t from, std::uint32_t to, ImageSize size, GLbitfield what) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, to);
    glBlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height, what, GL_NEAREST);
}

void bindTexture(TextureUnit unit, const GlTexture& texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture.id());
}

}  // namespace

Result<TransparencyPass> TransparencyPass::create() {
    Result<ShaderProgram> blend = ShaderProgram::create({"fullscreen.vert"}, {"blend.frag"});
    if (!blend) return blend.error();
    return TransparencyPass(std::move(*blend));
}

/// `samples`: 0 for one sample a pixel.
void TransparencyPass::allocate(ImageSize size, int samples) {
    if (m_size == size && m_samples == samples) return;
    m_size = size;
    m_samples = samples;
    m_colours = texture(size, GL_RGBA16F, GL_RGBA);
    m_weights = texture(size, GL_RGBA16F, GL_RGBA);
    m_behind = texture(size, GL_RGBA8, GL_RGBA);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_MIRRORED_REPEAT);
    m_image = GlFramebuffer::create();
    glBindFramebuffer(GL_FRAMEBUFFER, m_image.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, kColourTargets, GL_TEXTURE_2D, m_behind.id(), 0);
    m_resolved = GlFramebuffer::create();
    glBindFramebuffer(GL_FRAMEBUFFER, m_resolved.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, kColourTargets, GL_TEXTURE_2D, m_colours.id(), 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, kWeights, GL_TEXTURE_2D, m_weights.id(), 0);
    m_sums = {};
    if (samples > 0) {
        m_sums = GlFramebuffer::create();
        glBindFramebuffer(GL_FRAMEBUFFER, m_sums.id());
        m_multisampleColours = attached(kColourTargets, size, GL_RGBA16F, samples);
        m_multisampleWeights = attached(kWeights, size, GL_RGBA16F, samples);
    }
    m_depths = attached(GL_DEPTH_ATTACHMENT, size, GL_DEPTH_COMPONENT32F, samples);
}

void TransparencyPass::draw(const SceneBuffers& scene, ImageSize size, const Programs& programs, double focusDistance) {
    GLint bound = 0, samples = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    glGetIntegerv(GL_SAMPLES, &samples);
    const auto image = static_cast<GLuint>(bound);
    allocate(size, samples);
    const std::uint32_t sums = samples > 0 ? m_sums.id() : m_resolved.id();
    copy(image, sums, size, GL_DEPTH_BUFFER_BIT);
    copy(image, m_image.id(), size, GL_COLOR_BUFFER_BIT);

    glBindFramebuffer(GL_FRAMEBUFFER, sums);
    glDrawBuffers(2, kBoth);
    constexpr float kNoColour[] = {0.0f, 0.0f, 0.0f, 1.0f}, kNoWeight[] = {0.0f, 0.0f, 0.0f, 0.0f};
    glClearBufferfv(GL_COLOR, 0, kNoColour);
    glClearBufferfv(GL_COLOR, 1, kNoWeight);
    glEnable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFuncSeparate(GL_ONE, GL_ONE, GL_ZERO, GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
    glDepthFunc(GL_LESS);
    const auto drawWith = [&](const ShaderProgram& program, SceneBuffers::Batches batches) {
        program.use();
        program.set("surfaces", kTransparentSurfaces);
        program.set("focusDistance", static_cast<float>(focusDistance));
        scene.draw(SceneBuffers::Part::Bodies, batches);
    };
    drawWith(programs.plain, SceneBuffers::Batches::Plain);
    if (scene.hasFinishes()) drawWith(programs.finished, SceneBuffers::Batches::Finished);
    if (scene.hasTextures()) drawWith(programs.textured, SceneBuffers::Batches::Textured);
    glDisable(GL_CULL_FACE);
    for (const GLenum attachment : kBoth) {
        if (samples == 0) break;
        glBindFramebuffer(GL_FRAMEBUFFER, m_sums.id());
        glReadBuffer(attachment);
        glBindFramebuffer(GL_FRAMEBUFFER, m_resolved.id());
        glDrawBuffers(1, &attachment);
        copy(m_sums.id(), m_resolved.id(), size, GL_COLOR_BUFFER_BIT);
    }

    glBindFramebuffer(GL_FRAMEBUFFER, image);
    bindTexture(TextureUnit::Source, m_colours);
    bindTexture(TextureUnit::Mask, m_weights);
    bindTexture(TextureUnit::BaseColour, m_behind);
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);  // of what follows
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    m_blend.use();
    glBindVertexArray(m_emptyArray.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEnable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glDepthMask(GL_TRUE);
}

}  // namespace rubble
