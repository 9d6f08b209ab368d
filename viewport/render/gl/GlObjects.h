#pragma once

#include <cstdint>
#include <utility>

namespace rubble {

enum class GlKind { Buffer, Texture, Sampler, VertexArray, Framebuffer, Renderbuffer, Shader, Program };

/// Owns an OpenGL object name. Its context must be current on destruction.
template <GlKind kind>
class GlObject {
public:
    GlObject() = default;
    explicit GlObject(std::uint32_t id) : m_id(id) {}
    ~GlObject();
    GlObject(GlObject&& other) noexcept : m_id(std::exchange(other.m_id, 0)) {}
    GlObject& operator=(GlObject&& other) noexcept {
        std::swap(m_id, other.m_id);
        return *this;
    }

    /// Creates an object; none of a shader, which is created with its stage.
    static GlObject create();
    std::uint32_t id() const { return m_id; }

private:
    std::uint32_t m_id = 0;  // 0: none
};

using GlBuffer = GlObject<GlKind::Buffer>;
using GlTexture = GlObject<GlKind::Texture>;
using GlSampler = GlObject<GlKind::Sampler>;
using GlVertexArray = GlObject<GlKind::VertexArray>;
using GlFramebuffer = GlObject<GlKind::Framebuffer>;
using GlRenderbuffer = GlObject<GlKind::Renderbuffer>;
using GlShader = GlObject<GlKind::Shader>;
using GlProgram = GlObject<GlKind::Program>;

}  // namespace rubble
