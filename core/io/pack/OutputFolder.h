#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/io/output/ExportIndex.h"
#include "core/io/pack/ExportTarget.h"
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
    std::string project;  // the name of the project's file in the index, see indexName()
    PackOptions options;
    std::optional<ExportTarget> target;  // none: without a README.md
    bool hasAllAssets = true;            // all packs of the project are exported
    bool isWithScene = true;             // with scene.json, if the project has a scene
    EditedFiles edited = EditedFiles::Kept;
};

/// The name of a project's file as the index has it: a text, of whatever bytes.
std::string indexName(const std::filesystem::path& project);

/// The names of the files that an export writes into the output folder itself where all its packs succeed, the index
/// last.
std::vector<std::string> outputFileNames(const OutputRequest& request, const Project& project);

/// Completes an export whose packs are written: writes the scene, and how to use it, if all packs are in place, and
/// updates the index of the folder. `earlier` is that before the packs were written. Nothing if there is no folder.
///
/// Errors: those of writeOutputFiles() and changeExportIndex(); those of playScene() of a scene with bonds.
Status finishExport(const OutputRequest& request, const Project& project, std::span<const AssetExport> packs,
                    const std::optional<ExportIndex>& earlier, const TaskContext& task = {});

/// The folders that are there and that the project exported earlier and has no asset for any more. One that is also
/// that of an asset is not: "Wall" and "wall" on file systems that ignore case.
std::vector<std::string> stalePacks(const std::filesystem::path& folder, const std::string& name,
                                    const Project& project, const PackOptions& options,
                                    const std::optional<ExportIndex>& earlier);

}  // namespace rubble
