#pragma once

#include "core/base/Result.h"
#include "core/io/exchange/MeshPart.h"

#include <span>
#include <string>

namespace rubble {

/// Returns parts as a small binary glTF 2.0 file that is drawn at once: one skinned mesh, of which each part is
/// bound to a joint with its name, in numbers of 16 and 8 bits (KHR_mesh_quantization), compressed
/// (EXT_meshopt_compression). Both extensions are required to read it. Parts without a texture share a primitive,
/// with their colours at the vertices; above 65,536 parts there is a mesh for each so many. `name` is that of the
/// skeleton. See docs/formats/obj-glb.md.
///
/// Errors: Limit above 4 GiB, the maximum of the format.
Result<std::string> compactGlbFile(std::span<const MeshPart> parts, const MeshMaterials& materials, PartPlacement place,
                                   const std::string& name);

}  // namespace rubble
