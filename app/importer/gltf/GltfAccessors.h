#pragma once

#include "app/importer/gltf/GltfBuffers.h"

#include <memory>

namespace rubble {

/// The numbers of an accessor, one value after the other.
struct GltfNumbers {
    std::uint32_t components = 1;
    std::vector<double> numbers;
    double step = 0.0;   // to which they are quantized; 0: floats
    int normalBits = 0;  // that stand for the size of normalized integers; 0: others
    std::size_t count() const { return numbers.size() / components; }
    Vec3 vec3(std::size_t i) const { return {numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]}; }
    Vec2 vec2(std::size_t i) const { return {numbers[2 * i], numbers[2 * i + 1]}; }
};

/// The integer that stands for 1 in an accessor of this component type; 1 for floats.
double normalizedMost(std::uint32_t componentType);

/// Decodes accessors: integers, normalized or not, and floats, which become their shortest decimals; sparse ones; those
/// without a view are zero. Each is decoded once.
///
/// Errors: throws MeshError; those of GltfBuffers, BadInput for types and sizes that do not fit, Limit for too many
/// values.
class GltfAccessors {
public:
    GltfAccessors(const GltfDocument& document, GltfBuffers& buffers)
        : m_document(document), m_buffers(buffers), m_numbers(document.accessors.size()) {}

    /// Numbers of values with this many components.
    const GltfNumbers& numbers(std::uint32_t accessor, std::uint32_t components);
    std::vector<std::uint32_t> indices(std::uint32_t accessor);

private:
    GltfNumbers decoded(std::uint32_t index);
    void addSparse(const GltfAccessor& accessor, const std::string& name, GltfNumbers& numbers);

    const GltfDocument& m_document;
    GltfBuffers& m_buffers;
    std::vector<std::unique_ptr<GltfNumbers>> m_numbers;
};

}  // namespace rubble
