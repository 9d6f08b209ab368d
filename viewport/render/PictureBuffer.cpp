#include "viewport/render/PictureBuffer.h"

#include <epoxy/gl.h>

#include <cstring>

namespace rubble {

void PictureBuffer::resize(ImageSize size) {
    if (m_target.matches(size, 1)) return;
    m_target = RenderTarget(size, PixelFormat::Colour, 1);
    m_size = size;
    m_pixels.resize(std::size_t{4} * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height));
}

/// At once: for each row by itself, a software rasterizer would take ten times as long.
void PictureBuffer::read(std::uint8_t* rows, std::size_t rowBytes) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, m_target.framebuffer());
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, m_size.width, m_size.height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV, m_pixels.data());
    const std::size_t row = 4 * static_cast<std::size_t>(m_size.width);
    const auto height = static_cast<std::size_t>(m_size.height);
    for (std::size_t y = 0; y < height; ++y)
        std::memcpy(rows + y * rowBytes, m_pixels.data() + (height - 1 - y) * row, row);
}

}  // namespace rubble
