#pragma once

#include "viewport/render/GlObjects.h"

#include <cstddef>
#include <initializer_list>
#include <span>

namespace rubble {

/// Things that are drawn each by the same few corners, which a shader makes: an instance each. Written anew as they change.
class InstanceBuffer {
public:
    /// `floats`: how many numbers each attribute of an instance has, in order.
    explicit InstanceBuffer(std::initializer_list<int> floats);

    template <class T>
    void write(const std::span<const T>& instances) {
        write(std::as_bytes(instances), instances.size());
    }
    std::size_t count() const { return m_count; }
    /// Draws triangles of so many corners an instance by the program in use.
    void draw(int corners) const;

private:
    void write(std::span<const std::byte> bytes, std::size_t count);

    GlBuffer m_buffer = GlBuffer::made();
    GlVertexArray m_array = GlVertexArray::made();
    std::size_t m_count = 0;
};

}  // namespace rubble
