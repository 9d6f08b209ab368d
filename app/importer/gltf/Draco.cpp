#include "app/importer/gltf/Draco.h"

#include "app/importer/files/AssimpValues.h"

#include <draco/compression/decode.h>
#include <algorithm>

namespace rubble {
namespace {

std::optional<GltfNumbers> numbersOf(const draco::Mesh& mesh, std::uint32_t id) {
    const draco::PointAttribute* attribute = mesh.GetAttributeByUniqueId(id);
    if (attribute == nullptr || attribute->num_components() < 1 || attribute->num_components() > 4) return std::nullopt;
    GltfNumbers result{.components = static_cast<std::uint32_t>(attribute->num_components()), .numbers = {}};
    result.numbers.reserve(std::size_t{mesh.num_points()} * result.components);
    std::array<float, 4> value{};
    for (draco::PointIndex point(0); point < mesh.num_points(); ++point) {
        const draco::AttributeValueIndex index = attribute->mapped_index(point);
        if (index >= static_cast<std::uint32_t>(attribute->size())) return std::nullopt;
        if (!attribute->ConvertValue<float>(index, attribute->num_components(), value.data())) return std::nullopt;
        for (std::uint32_t k = 0; k < result.components; ++k) result.numbers.push_back(decimalOf(value[k]));
    }
    return result;
}

/// Normalizes integers that the compressed bytes have as they are.
void normalize(GltfNumbers& numbers, const GltfAccessor& accessor, const draco::PointAttribute& attribute) {
    const double most = normalizedMost(accessor.componentType);
    if (!accessor.isNormalized || attribute.normalized() || attribute.data_type() == draco::DT_FLOAT32) return;
    for (double& number : numbers.numbers) number = std::max(number / most, -1.0);
}

}  // namespace

std::optional<DracoMesh> dracoDecoded(std::string_view bytes, const GltfPrimitive& primitive,
                                      const GltfDocument& document) {
    draco::DecoderBuffer buffer;
    buffer.Init(bytes.data(), bytes.size());
    draco::Decoder decoder;
    const auto decoded = decoder.DecodeMeshFromBuffer(&buffer);
    if (!decoded.ok() || decoded.value() == nullptr) return std::nullopt;
    const draco::Mesh& mesh = *decoded.value();
    DracoMesh result;
    for (const auto& [name, id] : primitive.draco->attributes) {
        std::optional<GltfNumbers> numbers = numbersOf(mesh, id);
        if (!numbers) return std::nullopt;
        const auto accessor = primitive.attributes.find(name);
        if (accessor != primitive.attributes.end() && accessor->second < document.accessors.size())
            normalize(*numbers, document.accessors[accessor->second], *mesh.GetAttributeByUniqueId(id));
        (name == "POSITION" ? result.positions : result.others[name]) = std::move(*numbers);
    }
    if (result.positions.components != 3) return std::nullopt;
    result.indices.reserve(3 * std::size_t{mesh.num_faces()});
    for (draco::FaceIndex face(0); face < mesh.num_faces(); ++face)
        for (const draco::PointIndex& corner : mesh.face(face)) result.indices.push_back(corner.value());
    return result;
}

}  // namespace rubble
