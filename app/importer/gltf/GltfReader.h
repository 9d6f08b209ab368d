#pragma once

#include "app/importer/files/MeshFiles.h"
#include "core/geometry/mesh/SourceScene.h"

#include <string_view>

namespace rubble {

/// Reads the bytes of a glTF 2.0 file, .gltf or .glb: an object for each node of the shown scene with triangles, named
/// after the node or its mesh. Compressed and quantized meshes are decoded, morph targets applied with their default
/// weights, and skins with the pose of their joints. Instances of a node's mesh (EXT_mesh_gpu_instancing) that differ
/// by a rigid motion are copies of one object; others are objects.
///
/// Errors: throws MeshError; those of gltfChunks(), readGltfDocument() and GltfAccessors, BadInput for indices out of
/// range and nodes that are no tree, Limit above kMaxTriangles or kMaxCopies, Degenerate if all objects are hidden.
/// Images that are not read become notes.
SourceScene readGltf(std::string_view bytes, MeshFiles& files);

}  // namespace rubble
