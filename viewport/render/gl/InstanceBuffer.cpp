#include "viewport/render/gl/InstanceBuffer.h"

#include <epoxy/gl.h>

#include <numeric>

namespace rubble {

InstanceBuffer::InstanceBuffer(std::initializer_list<int> floats) {
    const auto stride = static_cast<GLsizei>(sizeof(float)) * std::accumulate(floats.begin(), floats.end(), 0);
    glBindVertexArray(m_array.id());
    glBindBuffer(GL_ARRAY_BUFFER, m_buffer.id());
    std::size_t offset = 0;
    GLuint attribute = 0;
    for (const int count : floats) {
        glVertexAttribPointer(attribute, count, GL_FLOAT, GL_FALSE, stride, reinterpret_cast<const void*>(offset));
        glVertexAttribDivisor(attribute, 1);
        glEnableVertexAttribArray(attribute++);
        offset += sizeof(float) * static_cast<std::size_t>(count);
    }
    glBindVertexArray(0);
}

void InstanceBuffer::write(std::span<const std::byte> bytes, std::size_t count) {
    m_count = count;
    if (count == 0) return;
    glBindBuffer(GL_ARRAY_BUFFER, m_buffer.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STREAM_DRAW);
}

void InstanceBuffer::draw(int vertices) const {
    if (m_count == 0) return;
    glBindVertexArray(m_array.id());
    glDrawArraysInstanced(GL_TRIANGLES, 0, vertices, static_cast<GLsizei>(m_count));
    glBindVertexArray(0);
}

}  // namespace rubble
