#pragma once

#include "app/importer/gltf/GltfDocument.h"

namespace rubble {

/// Decompresses the bytes of a view; nothing if they are damaged.
/// Source: Kapoulkine, EXT_meshopt_compression.
std::optional<std::string> meshoptDecoded(const GltfMeshopt& packed, std::string_view bytes);

}  // namespace rubble
