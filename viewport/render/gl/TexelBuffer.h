#pragma once

#include "viewport/render/gl/GlObjects.h"
#include "viewport/render/gl/ShaderProgram.h"

#include <array>
#include <cstddef>
#include <span>

namespace rubble {

/// A buffer texture that is rewritten often. Rotates through a few buffers, so that writing never waits for a draw call
/// and memory is reallocated only if the size changes.
class TexelBuffer {
public:
    /// `format`: the format of a texel, for glTexBuffer().
    TexelBuffer(TextureUnit unit, std::uint32_t format) : m_unit(unit), m_format(format) {}

    void write(std::span<const std::byte> bytes);
    /// Binds the buffer written last.
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
