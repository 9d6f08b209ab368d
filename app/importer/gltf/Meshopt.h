#pragma once

#include "app/importer/gltf/GltfDocument.h"

namespace rubble {

/// Decompresses the bytes of a view: `packed.count` elements of `packed.stride` bytes. Nothing if the bytes are
/// damaged, if mode, filter and stride do not belong together, or above 512 MiB.
///
/// Source: Kapoulkine, EXT_meshopt_compression.
std::optional<std::string> meshoptDecoded(const GltfMeshopt& packed, std::string_view bytes);

}  // namespace rubble
