#pragma once

#include "viewport/render/gl/GlObjects.h"
#include "viewport/scene/Camera.h"

namespace rubble {

enum class PixelFormat { Colour, Float, Number };

/// A framebuffer with a colour and a depth attachment.
class RenderTarget {
public:
    RenderTarget() = default;
    RenderTarget(ImageSize size, PixelFormat format, int samples);

    /// Whether it was created with these arguments.
    bool matches(ImageSize size, int samples) const { return m_size == size && m_samples == samples; }
    void bind() const;
    /// Copies the colours to a framebuffer, scaled to a size, which must be its own if there are several samples.
    void copyColours(std::uint32_t framebuffer, ImageSize size) const;
    std::uint32_t framebuffer() const { return m_framebuffer.id(); }
    std::uint32_t colourTexture() const { return m_colour.id(); }  // only if samples is 1

private:
    ImageSize m_size{0, 0};
    int m_samples = 0;
    GlFramebuffer m_framebuffer;
    GlTexture m_colour;
    GlRenderbuffer m_multisampleColour;
    GlRenderbuffer m_depth;
};

/// A copy of the depth buffer as a texture, for shaders that run later in the frame.
class DepthCopy {
public:
    /// Copies the depths of the bound framebuffer of a size, which stays bound.
    void copyBound(ImageSize size);
    /// Copies those of another one.
    void copy(std::uint32_t framebuffer, ImageSize size);
    /// Binds the texture to TextureUnit::Depths.
    void bind() const;

private:
    ImageSize m_size{0, 0};
    GlFramebuffer m_framebuffer;
    GlTexture m_depths;
};

}  // namespace rubble
