#include "app/importer/gltf/GltfAccessors.h"

#include "app/importer/files/AssimpValues.h"
#include "app/importer/files/MeshError.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace rubble {
namespace {

constexpr std::uint64_t kMaxNumbers = 40'000'000;  // of an accessor; 320 MB

std::string nameOf(std::uint32_t accessor) { return "accessors[" + std::to_string(accessor) + "]"; }

std::size_t componentSize(std::uint32_t type) {
    constexpr std::array<std::size_t, 7> kSizes = {1, 1, 2, 2, 0, 4, 4};
    return type < 5120 || type > 5126 ? 0 : kSizes[type - 5120];
}

template <class Number>
double valueAt(const char* bytes, bool isNormalized) {
    Number value;
    std::memcpy(&value, bytes, sizeof value);
    if constexpr (std::is_floating_point_v<Number>) return decimalOf(value);
    const auto number = static_cast<double>(value);
    constexpr auto kMost = static_cast<double>(std::numeric_limits<Number>::max());
    return isNormalized ? std::max(number / kMost, -1.0) : number;
}

double component(const char* bytes, std::uint32_t type, bool isNormalized) {
    switch (type) {
        case 5120: return valueAt<std::int8_t>(bytes, isNormalized);
        case 5121: return valueAt<std::uint8_t>(bytes, isNormalized);
        case 5122: return valueAt<std::int16_t>(bytes, isNormalized);
        case 5123: return valueAt<std::uint16_t>(bytes, isNormalized);
        case 5125: return valueAt<std::uint32_t>(bytes, isNormalized);
        default: return valueAt<float>(bytes, false);
    }
}

/// Values in the bytes of a view.
struct Layout {
    std::uint32_t type = 0;
    std::uint32_t components = 1;
    std::uint64_t count = 0;
    std::uint64_t offset = 0;
    std::uint64_t stride = 0;  // 0: values follow each other
    bool isNormalized = false;
};

void appendValues(std::string_view bytes, const Layout& layout, const std::string& name, std::vector<double>& to) {
    const std::size_t size = componentSize(layout.type);
    if (size == 0) failGltf(name + " has the unknown component type " + std::to_string(layout.type));
    const std::uint64_t value = size * layout.components;
    const std::uint64_t stride = layout.stride == 0 ? value : layout.stride;
    if (stride < value) failGltf(name + " has values that overlap");
    const bool fits = layout.count == 0 || (layout.offset <= bytes.size() && value <= bytes.size() - layout.offset &&
                                            layout.count - 1 <= (bytes.size() - layout.offset - value) / stride);
    if (!fits) failGltf(name + " ends behind its buffer view");
    for (std::uint64_t i = 0; i < layout.count; ++i)
        for (std::uint32_t k = 0; k < layout.components; ++k)
            to.push_back(
                component(bytes.data() + layout.offset + i * stride + k * size, layout.type, layout.isNormalized));
}

}  // namespace

double normalizedMost(std::uint32_t componentType) {
    constexpr std::array<double, 7> kMost = {127.0, 255.0, 32767.0, 65535.0, 1.0, 4294967295.0, 1.0};
    return componentType < 5120 || componentType > 5126 ? 1.0 : kMost[componentType - 5120];
}

const GltfNumbers& GltfAccessors::numbers(std::uint32_t index, std::uint32_t components) {
    if (index >= m_numbers.size())
        failGltf("it refers to accessor " + std::to_string(index) + " of " + std::to_string(m_numbers.size()));
    if (!m_numbers[index]) m_numbers[index] = std::make_unique<GltfNumbers>(decoded(index));
    const GltfNumbers& numbers = *m_numbers[index];
    if (numbers.components != components)
        failGltf(nameOf(index) + " has " + std::to_string(numbers.components) + " numbers a value; " +
                 std::to_string(components) + " are needed");
    return numbers;
}

std::vector<std::uint32_t> GltfAccessors::indices(std::uint32_t index) {
    const GltfNumbers& values = numbers(index, 1);
    std::vector<std::uint32_t> indices;
    indices.reserve(values.count());
    for (const double value : values.numbers) {
        if (!(value >= 0.0 && value <= 4294967295.0 && value == std::floor(value)))
            failGltf(nameOf(index) + " has a value that is no index");
        indices.push_back(static_cast<std::uint32_t>(value));
    }
    return indices;
}

GltfNumbers GltfAccessors::decoded(std::uint32_t index) {
    const GltfAccessor& accessor = m_document.accessors[index];
    const std::uint64_t size = std::uint64_t{accessor.count} * accessor.components;
    if (size > kMaxNumbers)
        throw MeshError(ErrorCode::Limit,
                        "has more than " + std::to_string(kMaxNumbers) + " numbers in " + nameOf(index));
    GltfNumbers numbers{.components = accessor.components, .numbers = {}};
    constexpr std::uint32_t kFloat = 5126;
    if (accessor.componentType != kFloat) {
        const double most = accessor.isNormalized ? normalizedMost(accessor.componentType) : 1.0;
        numbers.step = 1.0 / most;
        if (accessor.isNormalized) numbers.normalBits = static_cast<int>(std::log2(most + 1.0));
    }
    if (accessor.view) {
        const std::string_view bytes = m_buffers.view(*accessor.view);
        const Layout layout{.type = accessor.componentType,
                            .components = accessor.components,
                            .count = accessor.count,
                            .offset = accessor.offset,
                            .stride = m_document.views[*accessor.view].stride,
                            .isNormalized = accessor.isNormalized};
        appendValues(bytes, layout, nameOf(index), numbers.numbers);
    } else {
        numbers.numbers.resize(size, 0.0);
    }
    if (accessor.sparse) addSparse(accessor, nameOf(index), numbers);
    return numbers;
}

void GltfAccessors::addSparse(const GltfAccessor& accessor, const std::string& name, GltfNumbers& numbers) {
    const GltfSparse& sparse = *accessor.sparse;
    std::vector<double> places, values;
    appendValues(m_buffers.view(sparse.indicesView),
                 {.type = sparse.indicesType, .count = sparse.count, .offset = sparse.indicesOffset}, name, places);
    appendValues(m_buffers.view(sparse.valuesView),
                 {.type = accessor.componentType,
                  .components = accessor.components,
                  .count = sparse.count,
                  .offset = sparse.valuesOffset,
                  .isNormalized = accessor.isNormalized},
                 name, values);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!(places[i] >= 0.0 && places[i] < static_cast<double>(accessor.count)))
            failGltf(name + " replaces value " + std::to_string(static_cast<std::int64_t>(places[i])) + " of " +
                     std::to_string(accessor.count));
        const auto at = static_cast<std::ptrdiff_t>(places[i]) * static_cast<std::ptrdiff_t>(accessor.components);
        std::copy_n(values.begin() + static_cast<std::ptrdiff_t>(i * accessor.components), accessor.components,
                    numbers.numbers.begin() + at);
    }
}

}  // namespace rubble
