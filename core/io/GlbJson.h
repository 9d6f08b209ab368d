#pragma once

#include "core/io/GlbBuffer.h"
#include "core/io/MeshPart.h"

#include <span>
#include <string>
#include <vector>

namespace rubble {

/// The JSON chunk of a GLB file whose parts lie in `buffer` as `primitives` says, a list a part.
std::string glbJson(std::span<const MeshPart> parts, std::span<const std::vector<GlbPrimitive>> primitives,
                    const GlbBuffer& buffer, const MeshMaterials& materials, PartPlace place);

}  // namespace rubble
