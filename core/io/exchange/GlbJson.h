#pragma once

#include "core/io/exchange/GlbBuffer.h"
#include "core/io/exchange/GlbPhysics.h"
#include "core/io/exchange/MeshPart.h"
#include "core/io/json/JsonWriter.h"

#include <span>
#include <string>
#include <vector>

namespace rubble {

/// Returns the JSON chunk of a GLB file whose parts are in `buffer`; `primitives` has a list for each part.
/// With `physics`, whose hulls are in the buffer, the parts are rigid bodies.
std::string glbJson(std::span<const MeshPart> parts, std::span<const std::vector<GlbPrimitive>> primitives,
                    const GlbBuffer& buffer, const MeshMaterials& materials, PartPlacement place,
                    const GlbPhysics* physics = nullptr);

}  // namespace rubble
