#pragma once

#include "core/base/Hash.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace rubble {

/// A file of an export.
struct ExportFile {
    std::string name;  // without a path
    std::string bytes;
};

/// What happens to files of an earlier export that were modified since.
enum class EditedFiles { Kept, Replaced };

/// The name of the manifest in every export folder: the hash of its source, and name, size and hash of each file.
inline constexpr const char* kManifestName = "manifest.json";

/// Returns whether the folder is a complete, unmodified export of `source` according to its manifest. Reads all files.
bool isExportOf(const std::filesystem::path& folder, const ContentHash& source);

/// Returns the first error in an export folder, if there is one: a missing or unreadable manifest, a missing or
/// modified file, an unexpected file, a link, which is not followed. Files that engines write, such as
/// wall.glb.import, are expected. Reads all files.
std::optional<std::string> verifyExportFolder(const std::filesystem::path& folder);

/// Writes an export folder atomically: into a hidden folder beside `folder`, which is then exchanged for it. An
/// earlier export is replaced, except for what engines wrote in it; a link to a folder stays one. Permissions and
/// group are kept, and the owner where the user may give files away. On an error or a cancellation nothing changes.
/// Creates missing parent folders. Of several processes that write the same folder, the last one wins.
///
/// Errors: Io, with the path and the system's reason; BadInput if the folder holds an unexpected file, with its name;
/// Edited if it holds a modified one that is to be kept; Cancelled.
Status writeExportFolder(const std::filesystem::path& folder, const ContentHash& source,
                         std::span<const ExportFile> files, EditedFiles edited = EditedFiles::Kept,
                         const TaskContext& task = {});

}  // namespace rubble
