#pragma once

#include "core/asset/project/Project.h"
#include "core/asset/project/Variants.h"
#include "core/base/Diagnostic.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/io/output/ExportFolder.h"
#include "core/io/pack/PackFile.h"
#include "core/io/pack/PackMeshes.h"

#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// The result of exporting an asset or a variant of it.
struct AssetExport {
    Id asset = 0;
    std::string name;  // "wall"; for a variant "wall~2"
    std::filesystem::path folder;
    Status status = success();
    bool isReplacing = false;             // the folder existed before
    bool isUnchanged = false;             // the folder already was this export; the members below are not set
    std::size_t fragmentCount = 0;        // of all levels
    double volume = 0.0;                  // m³, of the whole
    std::vector<Diagnostic> diagnostics;  // of the bake
};

/// The settings of packs of a project that are exported so.
PackSettings packSettings(const Project& project, const PackOptions& options);

/// Returns a hash of all inputs of the pack of an asset, in the variant that is exported: the source in the manifest of
/// its folder.
ContentHash packSourceHash(const Project& project, const Asset& asset, const PackNames& names,
                           const PackOptions& options);

/// The names of each pack of a project. The folders are the distinctFileNames() of its assets without blanks, in their
/// order, then of the variants that instances use ("wall_2"); none is that of the index, export.json. They depend on
/// all assets, so that these may be exported one by one.
std::map<AssetVariant, PackNames> packNames(const Project& project, const PackOptions& options = {});

/// The folder of a pack and the files in it.
struct PackListing {
    std::string folder;  // its name
    PackFileNames files;
};

/// Returns the folders that exportPacks() writes, in its order, with their files. Assets that the project does not have
/// are skipped. Fractures nothing.
std::vector<PackListing> packListings(const Project& project, std::span<const Id> assets, const PackOptions& options);

/// Writes the packs of `assets`, pack.json and meshes, each into a folder below `folder`, see packNames(). Each
/// variant that instances use gets a pack of its own after that of its asset. Folders that are complete, unmodified
/// exports of the same source are not rewritten. Leftovers of killed exports in `folder` are removed. An asset that
/// fails is reported in its status; the others are written.
/// Exports up to task.threads assets at once; the bytes do not depend on their number.
///
/// Errors: NotFound if there is no asset with an id; Io if `folder` cannot be created; Cancelled. On an error existing
/// folders are unchanged and no empty one remains.
Result<std::vector<AssetExport>> exportPacks(const Project& project, std::span<const Id> assets,
                                             const std::filesystem::path& folder, const PackOptions& options,
                                             EditedFiles edited = EditedFiles::Kept, const TaskContext& task = {},
                                             FolderLocking locking = FolderLocking::Here);

/// What exportPacks() would do with each folder: whether it is unchanged, would be replaced, or is refused. Changes
/// nothing and fractures nothing: that an asset cannot be fractured is not reported.
///
/// Errors: NotFound and Limit as those of exportPacks(); Cancelled.
Result<std::vector<AssetExport>> planPacks(const Project& project, std::span<const Id> assets,
                                           const std::filesystem::path& folder, const PackOptions& options,
                                           EditedFiles edited = EditedFiles::Kept, const TaskContext& task = {});

}  // namespace rubble
