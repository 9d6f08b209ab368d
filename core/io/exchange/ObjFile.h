#pragma once

#include "core/io/exchange/MeshPart.h"

#include <span>
#include <string>

namespace rubble {

/// Returns parts as a Wavefront OBJ file that refers to `materialFile`: y up, metres; each part is an object and a
/// group with its name, its faces sorted by material, outside first, with flat normals. See docs/formats/obj-glb.md.
std::string objFile(std::span<const MeshPart> parts, const MeshMaterials& materials, PartPlacement place,
                    const std::string& materialFile);

/// Returns materials as an MTL file.
std::string mtlFile(const MeshMaterials& materials);

}  // namespace rubble
