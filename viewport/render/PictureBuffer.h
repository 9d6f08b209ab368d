#pragma once

#include "viewport/render/gl/RenderTarget.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rubble {

/// A framebuffer whose pixels are read back.
class PictureBuffer {
public:
    /// Makes it as large as a picture; the content is lost if the size changes.
    void resize(ImageSize size);
    std::uint32_t framebuffer() const { return m_target.framebuffer(); }

    /// Waits until everything is drawn and writes the pixels to rows from top to bottom, `rowBytes` apart. Each is four
    /// bytes as a native 0xffrrggbb.
    void read(std::uint8_t* rows, std::size_t rowBytes);

private:
    RenderTarget m_target;
    ImageSize m_size{0, 0};
    std::vector<std::uint8_t> m_pixels;  // from bottom to top
};

}  // namespace rubble
