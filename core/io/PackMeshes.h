#pragma once

#include "core/asset/Bake.h"
#include "core/base/TaskContext.h"
#include "core/io/ExportFolder.h"
#include "core/io/PackFile.h"

#include <vector>

namespace rubble {

/// Which fragments share a mesh file.
enum class FileSplit {
    Single,       // those that are not broken again in one file, those of each level that are in another
    PerFragment,  // a file each
};

/// What the faces of an OBJ file are. Those of a GLB file are always triangles.
enum class FaceShape { Polygons, Triangles };

/// Which mesh files an export writes, and how.
struct MeshOptions {
    bool obj = true;
    bool glb = true;
    FileSplit split = FileSplit::Single;
    PartPlace place = PartPlace::Assembled;
    FaceShape faces = FaceShape::Polygons;
    bool operator==(const MeshOptions&) const = default;
};

/// The mesh files of a pack: how pack.json lists them, and all files, the materials' among them.
struct PackMeshes {
    std::vector<PackMeshFile> list;
    std::vector<ExportFile> files;
};

/// The meshes of an asset, in the same order always: the whole, then the fragments. docs/formats/obj-glb.md tells which file
/// holds what.
///
/// Errors: those of glbFile(); Cancelled.
Result<PackMeshes> packMeshes(const Bake& bake, const Asset& asset, const AssetMaterials& material,
                              const MeshOptions& options, const TaskContext& task = {});

}  // namespace rubble
