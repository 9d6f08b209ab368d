#pragma once

#include "app/importer/gltf/GltfAccessors.h"

namespace rubble {

/// A decompressed primitive.
struct DracoMesh {
    std::vector<std::uint32_t> indices;
    GltfNumbers positions{.components = 3, .numbers = {}};
    std::map<std::string, GltfNumbers, std::less<>> others;  // texture coordinates, joints and weights
};

/// Decompresses a primitive; nothing if the bytes are damaged or the primitive has no positions.
/// Source: KHR_draco_mesh_compression.
std::optional<DracoMesh> dracoDecoded(std::string_view bytes, const GltfAttributes& attributes);

}  // namespace rubble
