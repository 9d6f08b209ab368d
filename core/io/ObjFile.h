#pragma once

#include "core/io/MeshPart.h"

#include <span>
#include <string>

namespace rubble {

/// The parts as one Wavefront OBJ file beside which the file `materialFile` lies: y up, metres, for each part an object and
/// a group of its name, its faces in one run a material, outside before inside, with flat normals. See docs/formats/obj-glb.md.
std::string objFile(std::span<const MeshPart> parts, const MeshMaterials& materials, PartPlace place,
                    const std::string& materialFile);

/// The materials as an MTL file.
std::string mtlFile(const MeshMaterials& materials);

}  // namespace rubble
