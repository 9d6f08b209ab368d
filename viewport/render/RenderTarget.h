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

/// How far what was drawn is from the eye, to be read by what is drawn after it.
class DepthCopy {
public:
    /// Copies the depths of the framebuffer that is bound, which stays so, of a size.
    void take(PictureSize size);
    std::uint32_t texture() const { return m_depths.id(); }

private:
    PictureSize m_size{0, 0};
    GlFramebuffer m_framebuffer;
    GlTexture m_depths;
};

/// Copies the colours of one framebuffer to another of the same size.
void copyColours(std::uint32_t from, std::uint32_t to, PictureSize size);

}  // namespace rubble
