#include "viewport/render/gl/GlObjects.h"

#include <epoxy/gl.h>

namespace rubble {

template <GlKind kind>
GlObject<kind> GlObject<kind>::create() {
    GLuint id = 0;
    if constexpr (kind == GlKind::Buffer) glGenBuffers(1, &id);
    if constexpr (kind == GlKind::Texture) glGenTextures(1, &id);
    if constexpr (kind == GlKind::Sampler) glGenSamplers(1, &id);
    if constexpr (kind == GlKind::VertexArray) glGenVertexArrays(1, &id);
    if constexpr (kind == GlKind::Framebuffer) glGenFramebuffers(1, &id);
    if constexpr (kind == GlKind::Renderbuffer) glGenRenderbuffers(1, &id);
    if constexpr (kind == GlKind::Program) id = glCreateProgram();
    return GlObject(id);
}

template <GlKind kind>
GlObject<kind>::~GlObject() {
    if (m_id == 0) return;
    if constexpr (kind == GlKind::Buffer) glDeleteBuffers(1, &m_id);
    if constexpr (kind == GlKind::Texture) glDeleteTextures(1, &m_id);
    if constexpr (kind == GlKind::Sampler) glDeleteSamplers(1, &m_id);
    if constexpr (kind == GlKind::VertexArray) glDeleteVertexArrays(1, &m_id);
    if constexpr (kind == GlKind::Framebuffer) glDeleteFramebuffers(1, &m_id);
    if constexpr (kind == GlKind::Renderbuffer) glDeleteRenderbuffers(1, &m_id);
    if constexpr (kind == GlKind::Shader) glDeleteShader(m_id);
    if constexpr (kind == GlKind::Program) glDeleteProgram(m_id);
}

template class GlObject<GlKind::Buffer>;
template class GlObject<GlKind::Texture>;
template class GlObject<GlKind::Sampler>;
template class GlObject<GlKind::VertexArray>;
template class GlObject<GlKind::Framebuffer>;
template class GlObject<GlKind::Renderbuffer>;
template class GlObject<GlKind::Shader>;
template class GlObject<GlKind::Program>;

}  // namespace rubble
