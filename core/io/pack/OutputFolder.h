#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/io/formats/ExportTarget.h"
#include "core/io/output/ExportIndex.h"
#include "core/io/pack/PackExport.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// An export of a project into an output folder.
struct OutputRequest {
    std::filesystem::path folder;
    std::string project;     // the name of the project's file in the index, see indexName()
    bool isPruning = false;  // removes stalePacks()
    PackOptions options;
    const ExportTarget* target = nullptr;  // null: without a README.md
    bool hasAllAssets = true;              // all packs of the project are exported
    bool isWithScene = true;               // with scene.json, if the project has a scene
    EditedFiles edited = EditedFiles::Kept;
};

/// The name of a project's file as the index has it: a text, of whatever bytes.
std::string indexName(const std::filesystem::path& project);

/// The names of the files that an export writes into the output folder itself where all its packs succeed, the index
/// last.
std::vector<std::string> outputFileNames(const OutputRequest& request, const Project& project);

/// A folder that no asset of the project has any more.
struct PrunedFolder {
    std::filesystem::path folder;
    Status status = success();  // an error if it is not removed
};

/// A folder whose asset has another name now.
struct RenamedFolder {
    std::string from, to;  // names
};

/// What an export into an output folder did.
struct OutputExport {
    std::vector<AssetExport> packs;    // as exportPacks() reports them
    std::vector<PrunedFolder> pruned;  // none if it was not to prune
    std::vector<std::string> stale;    // stalePacks() that were not to be pruned
    std::vector<RenamedFolder> renamed;
    Status finished = success();  // an error if the scene, how to use it, or the index could not be written
};

/// Exports assets of a project: renames the folders of renamed assets, with what engines wrote for their files; writes
/// their packs, see exportPacks(); how to use them; the scene, if all packs are in place, else that of before stays;
/// and the index. The output folder is locked meanwhile: processes that export into one folder take turns, and the last
/// one wins.
///
/// Errors: those of exportPacks(), readExportIndex(), lockFolder(), and checkOutputFiles(); Edited if a folder is of
/// the export of another project and is to be kept. Nothing was written then.
Result<OutputExport> exportToFolder(const OutputRequest& request, const Project& project, std::span<const Id> assets,
                                    const TaskContext& task = {});

/// The folders that are there and that the project exported earlier and has no asset for any more. One that is also
/// that of an asset is not: "Wall" and "wall" on file systems that ignore case.
std::vector<std::string> stalePacks(const OutputRequest& request, const Project& project,
                                    const std::optional<ExportIndex>& earlier);

}  // namespace rubble
