#pragma once

#include "viewport/render/GlObjects.h"
#include "viewport/render/ShaderProgram.h"

#include <array>
#include <cstddef>
#include <span>

namespace rubble {

/// Numbers that shaders look up by index and that are often written anew: in turns to one of a few buffers, so that no
/// writing waits for a drawing, and no memory is asked for while the amount stays the same.
class TexelBuffer {
public:
    /// `format`: of a texel, as glTexBuffer() takes it.
    TexelBuffer(TextureUnit unit, std::uint32_t format) : m_unit(unit), m_format(format) {}

    void write(std::span<const std::byte> bytes);
    /// Makes what was written last readable.
    void bind() const;

private:
    struct Slot {
        GlBuffer buffer;
        GlTexture texels;
        std::size_t size = 0;
    };
    TextureUnit m_unit;
    std::uint32_t m_format;
    std::array<Slot, 3> m_slots;
    std::size_t m_last = 0;
};

}  // namespace rubble
