#pragma once

#include "app/importer/gltf/GltfAccessors.h"

namespace rubble {

/// A decompressed primitive.
struct DracoMesh {
    std::vector<std::uint32_t> indices;
    GltfNumbers positions{.components = 3, .numbers = {}};
    std::map<std::string, GltfNumbers, std::less<>> others;  // texture coordinates, joints and weights
};

/// Decompresses a primitive of a document; nothing if the bytes are damaged or the primitive has no positions. Integers
/// are normalized where the primitive's accessors say so.
/// Source: KHR_draco_mesh_compression.
std::optional<DracoMesh> dracoDecoded(std::string_view bytes, const GltfPrimitive& primitive,
                                      const GltfDocument& document);

}  // namespace rubble
