#pragma once

#include "viewport/render/gl/GlObjects.h"

#include <cstddef>
#include <initializer_list>
#include <span>

namespace rubble {

/// Instance attributes of shapes whose few vertices a shader generates. Rewritten when they change.
class InstanceBuffer {
public:
    /// `floats`: the number of floats of each attribute, in order.
    explicit InstanceBuffer(std::initializer_list<int> floats);

    template <class T>
    void write(const std::span<const T>& instances) {
        write(std::as_bytes(instances), instances.size());
    }
    std::size_t count() const { return m_count; }
    /// Draws triangles of `vertices` vertices per instance with the current program.
    void draw(int vertices) const;

private:
    void write(std::span<const std::byte> bytes, std::size_t count);

    GlBuffer m_buffer = GlBuffer::create();
    GlVertexArray m_array = GlVertexArray::create();
    std::size_t m_count = 0;
};

}  // namespace rubble
