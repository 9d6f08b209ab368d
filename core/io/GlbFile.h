#pragma once

#include "core/base/Result.h"
#include "core/io/MeshPart.h"

#include <span>
#include <string>

namespace rubble {

/// The parts as one binary glTF 2.0 file: y up, metres, for each part a node of its name with a mesh in float32, in
/// triangles with flat normals, one primitive a material, outside before inside. See docs/formats/obj-glb.md.
///
/// Errors: Limit above 4 GiB, which is the most that the format can hold.
Result<std::string> glbFile(std::span<const MeshPart> parts, const MeshMaterials& materials, PartPlace place);

}  // namespace rubble
