#include "viewport/render/LightBuffer.h"

#include <epoxy/gl.h>

namespace rubble {
namespace {

void bindTexels(TextureUnit unit, const GlTexture& texture) {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, texture.id());
}

/// A texture that is read texel by texel.
GlTexture texels(ImageSize size, GLenum format, GLenum components, GLenum type) {
    GlTexture made = GlTexture::create();
    bindTexels(TextureUnit::Source, made);
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), size.width, size.height, 0, components, type, nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return made;
}

void attach(const GlFramebuffer& framebuffer, GLenum attachment, const GlTexture& texture) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.id());
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, texture.id(), 0);
}

}  // namespace

void LightBuffer::allocate(ImageSize size) {
    const ImageSize needed{(size.width + kPixels - 1) / kPixels, (size.height + kPixels - 1) / kPixels};
    if (needed == m_size) return;
    m_size = needed;
    m_surfaces = GlFramebuffer::create();
    m_normals = texels(m_size, GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE);
    m_depths = texels(m_size, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT);
    attach(m_surfaces, GL_COLOR_ATTACHMENT0, m_normals);
    attach(m_surfaces, GL_DEPTH_ATTACHMENT, m_depths);
    for (Target* target : {&m_raw, &m_smooth}) {
        target->framebuffer = GlFramebuffer::create();
        target->texels = texels(m_size, GL_RGBA32F, GL_RGBA, GL_FLOAT);
        attach(target->framebuffer, GL_COLOR_ATTACHMENT0, target->texels);
    }
}

void LightBuffer::draw(const SceneBuffers& scene, const RenderPrograms& programs, ImageSize size) {
    allocate(size);
    glViewport(0, 0, m_size.width, m_size.height);
    glBindFramebuffer(GL_FRAMEBUFFER, m_surfaces.id());
    constexpr float kNoSurface[] = {0.0f, 0.0f, 0.0f, 0.0f};
    glClearBufferfv(GL_COLOR, 0, kNoSurface);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glClear(GL_DEPTH_BUFFER_BIT);
    glDisable(GL_BLEND);
    glEnable(GL_CULL_FACE);
    programs.surfaces.use();
    programs.surfaces.set("surfaces", kOpaqueSurfaces);
    scene.draw(SceneBuffers::Part::Silhouettes);
    glDisable(GL_CULL_FACE);

    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(m_emptyArray.id());
    bindTexels(TextureUnit::Depths, m_depths);
    bindTexels(TextureUnit::Mask, m_normals);
    glBindFramebuffer(GL_FRAMEBUFFER, m_raw.framebuffer.id());
    programs.light.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    bindTexels(TextureUnit::Source, m_raw.texels);
    glBindFramebuffer(GL_FRAMEBUFFER, m_smooth.framebuffer.id());
    programs.lightBlur.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glEnable(GL_DEPTH_TEST);
}

void LightBuffer::bind() const { bindTexels(TextureUnit::LightBuffer, m_smooth.texels); }

}  // namespace rubble
