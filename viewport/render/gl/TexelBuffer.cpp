#include "viewport/render/gl/TexelBuffer.h"

#include <epoxy/gl.h>

namespace rubble {

void TexelBuffer::write(std::span<const std::byte> bytes) {
    m_last = (m_last + 1) % m_slots.size();
    Slot& slot = m_slots[m_last];
    const auto size = static_cast<GLsizeiptr>(bytes.size());
    if (slot.buffer.id() == 0) {
        slot.buffer = GlBuffer::create();
        slot.texels = GlTexture::create();
    }
    glBindBuffer(GL_TEXTURE_BUFFER, slot.buffer.id());
    if (slot.size == bytes.size()) {
        glBufferSubData(GL_TEXTURE_BUFFER, 0, size, bytes.data());
        return;
    }
    slot.size = bytes.size();
    glBufferData(GL_TEXTURE_BUFFER, size, bytes.data(), GL_DYNAMIC_DRAW);
    bind();
    glTexBuffer(GL_TEXTURE_BUFFER, m_format, slot.buffer.id());
}

void TexelBuffer::bind() const {
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(m_unit));
    glBindTexture(GL_TEXTURE_BUFFER, m_slots[m_last].texels.id());
}

}  // namespace rubble
