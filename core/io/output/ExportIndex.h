#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/io/output/ExportManifest.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace rubble {

/// The name of the index in every output folder.
inline constexpr const char* kIndexName = "export.json";

/// What an output folder holds, so that later exports know what is theirs: docs/formats/manifest.md.
struct ExportIndex {
    std::string project;               // the file name of the project
    std::vector<std::string> folders;  // of packs, names without a path
    std::vector<ManifestEntry> files;  // of the export in the output folder itself, without this one
    bool operator==(const ExportIndex&) const = default;
};

std::string exportIndexJson(const ExportIndex& index);

/// The index of an output folder; nothing if there is none.
///
/// Errors: BadInput or Unsupported, with the path, if the file is not an index that this version can read, or names
/// folders or files elsewhere; those of readFile() but for NotFound.
Result<std::optional<ExportIndex>> readExportIndex(const std::filesystem::path& folder);

/// Replaces the index of an output folder by what `change` makes of it, without any other process doing so at the same
/// time. Written atomically, and only if it differs; an empty one is not created.
///
/// Errors: those of readExportIndex(), lockFolder() and writeFileAtomically().
Status changeExportIndex(const std::filesystem::path& folder,
                         const std::function<ExportIndex(const std::optional<ExportIndex>&)>& change,
                         const TaskContext& task = {});

/// Whether an index is of a project. That of a project without a file is of any.
bool isIndexOf(const std::optional<ExportIndex>& index, const std::string& project);

/// The folders of an earlier index that no asset of the project has any more. None if it is of another project.
std::vector<std::string> staleFolders(const std::optional<ExportIndex>& earlier, const std::string& project,
                                      std::span<const std::string> current);

/// The index after an export. `current` are the folders of all assets of the project, in their order; of these it has
/// those `exported` now or listed before; then come the stale ones that `kept` has. Files are those of before.
ExportIndex indexAfterExport(const std::optional<ExportIndex>& earlier, const std::string& project,
                             std::span<const std::string> current, const std::set<std::string>& exported,
                             std::span<const std::string> kept);

}  // namespace rubble
