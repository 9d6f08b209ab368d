#pragma once

#include "core/asset/Project.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/Report.h"
#include "core/io/PackMeshes.h"

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// What became of one asset, or of one variant of it, at an export.
struct AssetExport {
    Id asset = 0;
    std::string name;  // "wall"; of a variant "wall~2"
    std::filesystem::path folder;
    Status status = success();
    bool isUnchanged = false;       // its folder was this very export before; then what follows is not known
    std::size_t fragmentCount = 0;  // of all levels
    double volume = 0.0;            // m^3, of the whole
    std::vector<Report> reports;    // of the bake
};

/// The hash of all that an asset's pack depends on: what the manifest of its folder names as its source.
ContentHash packSource(const Project& project, const Asset& asset, const MeshOptions& options);

/// Writes the packs of `assets`, each into a folder of its name below `folder`: pack.json and meshes; and one more for each
/// variant that instances use ("wall_2"), in the order of their numbers behind their asset's. Folders that are
/// whole, unaltered exports of the same source stay as they are. A fault of one asset is told in its status and keeps no
/// other from being written. Up to task.threads assets at once; the bytes are the same at any number of them.
///
/// Errors: NotFound where an id names no asset; BadInput where two assets would go to the same folder (on a system
/// that takes "Wall" and "wall" for one, too), naming both; Io where `folder` cannot be made; Cancelled. What is cancelled
/// or refused leaves its folder as it was, and no empty one behind.
Result<std::vector<AssetExport>> exportPacks(const Project& project, std::span<const Id> assets,
                                             const std::filesystem::path& folder, const MeshOptions& options,
                                             const TaskContext& task = {});

}  // namespace rubble
