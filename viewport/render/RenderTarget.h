#pragma once

#include "viewport/render/GlObjects.h"
#include "viewport/scene/Camera.h"

namespace rubble {

enum class PixelFormat { Colour, Float, BodyIndex };

/// Something to draw to: colour, and depth beside it.
class RenderTarget {
public:
    RenderTarget() = default;
    RenderTarget(PictureSize size, PixelFormat format, int samples);

    /// Whether it was made like this. `samples` is what was asked for.
    bool isLike(PictureSize size, int samples) const { return m_size == size && m_samples == samples; }
    void bind() const;
    std::uint32_t framebuffer() const { return m_framebuffer.id(); }
    std::uint32_t colourTexture() const { return m_colour.id(); }  // where samples is 1

private:
    PictureSize m_size{0, 0};
    int m_samples = 0;
    GlFramebuffer m_framebuffer;
    GlTexture m_colour;
    GlRenderbuffer m_manyColours;
    GlRenderbuffer m_depth;
};

/// Copies the colours of one framebuffer to another of the same size.
void copyColours(std::uint32_t from, std::uint32_t to, PictureSize size);

}  // namespace rubble
