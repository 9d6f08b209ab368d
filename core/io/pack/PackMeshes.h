#pragma once

#include "core/base/TaskContext.h"
#include "core/io/exchange/PackBuilder.h"
#include "core/io/formats/PackOptions.h"
#include "core/io/output/ExportFolder.h"

#include <string>
#include <vector>

namespace rubble {

/// The memory that the meshes of a fragment take while they are exported, bytes.
double meshBytesPerFragment(const MeshOptions& options);

/// The mesh files of a pack.
struct PackMeshes {
    std::vector<PackMeshFile> list;  // for pack.json
    std::vector<ExportFile> files;   // also those that pack.json does not list, and images beside them
};

/// The names of the files in the folder of a pack, as far as they are known before the asset is fractured.
struct PackFileNames {
    std::vector<std::string> names;
    bool areAll = true;  // false: there may be mesh files of single fragments, or of fragments of a level that break
};

/// Returns the names of the files of packMeshes(), in their order as far as they are known.
PackFileNames meshFileNames(const Asset& asset, const AssetMaterials& materials, const PackNames& names,
                            const MeshOptions& options);

/// Returns the meshes of an asset in all formats of the options, the whole first. The files are described in
/// docs/formats/obj-glb.md and usd-mjcf.md.
///
/// Errors: those of the formats, see exportFormats(), and of bakedTextures(); Cancelled.
Result<PackMeshes> packMeshes(const PackBuilder& builder, const MeshOptions& options, const TaskContext& task = {});

}  // namespace rubble
