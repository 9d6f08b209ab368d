#include "viewport/render/gl/RenderTarget.h"

#include "viewport/render/gl/ShaderProgram.h"

#include <epoxy/gl.h>

#include <algorithm>

namespace rubble {
namespace {

struct GlFormat {
    GLenum internal;
    GLenum components;
    GLenum type;
};
GlFormat glFormat(PixelFormat format) {
    switch (format) {
        case PixelFormat::Float: return {GL_RGBA32F, GL_RGBA, GL_FLOAT};
        case PixelFormat::Number: return {GL_R32UI, GL_RED_INTEGER, GL_UNSIGNED_INT};
        case PixelFormat::Colour: break;
    }
    return {GL_RGBA8, GL_RGBA, GL_UNSIGNED_BYTE};
}

int supported(int samples) {
    GLint max = 1;
    glGetIntegerv(GL_MAX_SAMPLES, &max);
    return std::clamp(samples, 1, std::max(max, 1));
}

}  // namespace

RenderTarget::RenderTarget(ImageSize size, PixelFormat format, int samples)
    : m_size(size), m_samples(samples), m_framebuffer(GlFramebuffer::create()), m_depth(GlRenderbuffer::create()) {
    const GlFormat gl = glFormat(format);
    const int count = supported(samples) > 1 ? supported(samples) : 0;
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id());
    if (count == 0) {
        m_colour = GlTexture::create();
        glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(TextureUnit::Source));
        glBindTexture(GL_TEXTURE_2D, m_colour.id());
        glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(gl.internal), size.width, size.height, 0, gl.components,
                     gl.type, nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_colour.id(), 0);
    } else {
        m_multisampleColour = GlRenderbuffer::create();
        glBindRenderbuffer(GL_RENDERBUFFER, m_multisampleColour.id());
        glRenderbufferStorageMultisample(GL_RENDERBUFFER, count, gl.internal, size.width, size.height);
        glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, m_multisampleColour.id());
    }
    glBindRenderbuffer(GL_RENDERBUFFER, m_depth.id());
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, count, GL_DEPTH_COMPONENT32F, size.width, size.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, m_depth.id());
}

void RenderTarget::bind() const {
    glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id());
    glViewport(0, 0, m_size.width, m_size.height);
}

void RenderTarget::copyColours(std::uint32_t framebuffer, ImageSize size) const {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_framebuffer.id());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, m_size.width, m_size.height, 0, 0, size.width, size.height, GL_COLOR_BUFFER_BIT,
                      size == m_size ? GL_NEAREST : GL_LINEAR);
}

void DepthCopy::copyBound(ImageSize size) {
    GLint bound = 0;
    glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
    copy(static_cast<GLuint>(bound), size);
    glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(bound));
}

void DepthCopy::copy(std::uint32_t framebuffer, ImageSize size) {
    if (m_size != size) {
        m_size = size;
        m_framebuffer = GlFramebuffer::create();
        m_depths = GlTexture::create();
        bind();
        glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, size.width, size.height, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                     nullptr);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glBindFramebuffer(GL_FRAMEBUFFER, m_framebuffer.id());
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, m_depths.id(), 0);
        glDrawBuffer(GL_NONE);
        glReadBuffer(GL_NONE);
    }
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, m_framebuffer.id());
    glBlitFramebuffer(0, 0, size.width, size.height, 0, 0, size.width, size.height, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

void DepthCopy::bind() const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(TextureUnit::Depths));
    glBindTexture(GL_TEXTURE_2D, m_depths.id());
}

}  // namespace rubble
