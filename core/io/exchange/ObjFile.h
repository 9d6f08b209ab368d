#pragma once

#include "core/geometry/mesh/UpAxis.h"
#include "core/io/exchange/MeshPart.h"

#include <span>
#include <string>

namespace rubble {

/// The unit of the coordinates in an OBJ file.
enum class ObjUnit { Metre, Centimetre, Millimetre };

/// The frame of the coordinates in an OBJ file, which the format leaves open.
struct ObjFrame {
    UpAxis up = UpAxis::Y;
    ObjUnit unit = ObjUnit::Metre;
    bool operator==(const ObjFrame&) const = default;
};

/// Returns parts as a Wavefront OBJ file that refers to `materialFile`: each part is an object and a group with its
/// name, its faces sorted by material, outside first, with flat normals. See docs/formats/obj-glb.md.
std::string objFile(std::span<const MeshPart> parts, const MeshMaterials& materials, PartPlacement place,
                    const std::string& materialFile, const ObjFrame& frame = {});

/// Returns materials as an MTL file, which refers to their image by its name.
std::string mtlFile(const MeshMaterials& materials);

}  // namespace rubble
