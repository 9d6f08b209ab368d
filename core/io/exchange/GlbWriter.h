#pragma once

#include "core/base/Result.h"
#include "core/io/exchange/GlbPhysics.h"
#include "core/io/exchange/MeshPart.h"

#include <span>
#include <string>

namespace rubble {

/// Returns parts as a binary glTF 2.0 file: y up, metres; each part is a node with its name and a mesh of triangles in
/// float32 with flat normals, one primitive per material, outside first; the images of textured and baked materials
/// are parts of the file, unless they lie beside it. Baked materials need meshes with tangents. With `physics`, each
/// part is a rigid body with its hulls as colliders. See docs/formats/obj-glb.md.
///
/// Errors: Limit above 4 GiB, the maximum of the format.
Result<std::string> glbFile(std::span<const MeshPart> parts, const MeshMaterials& materials, PartPlacement place,
                            const GlbPhysics* physics = nullptr);

}  // namespace rubble
