#pragma once

#include "core/base/Hash.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"

#include <filesystem>
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

/// Who keeps other processes from replacing folders beside an export: the function that writes it, for as long as it
/// exchanges folders, or its caller, who holds lockFolder() of their parent for a whole export of several.
enum class FolderLocking { Here, ByCaller };

/// Writes an export folder atomically: into a hidden folder beside `folder`, which is then exchanged for it. An
/// earlier export is replaced, except for what engines wrote in it; a link to a folder stays one. Permissions and
/// group are kept, and the owner where the user may give files away. On an error or a cancellation nothing changes.
/// Creates missing parent folders. Of several processes that write the same folder, the last one wins.
///
/// Errors: Io, with the path and the system's reason; BadInput if the folder holds an unexpected file, with its name;
/// Edited if it holds a modified one that is to be kept; Cancelled.
Status writeExportFolder(const std::filesystem::path& folder, const ContentHash& source,
                         std::span<const ExportFile> files, EditedFiles edited = EditedFiles::Kept,
                         const TaskContext& task = {}, FolderLocking locking = FolderLocking::Here);

/// Whether writeExportFolder() could replace a folder, or create it. Changes nothing.
///
/// Errors: those of writeExportFolder() but for Cancelled.
Status checkExportFolder(const std::filesystem::path& folder, EditedFiles edited = EditedFiles::Kept);

/// Whether removeExportFolder() could remove a folder. Changes nothing.
///
/// Errors: those of removeExportFolder() but for Cancelled.
Status checkRemovable(const std::filesystem::path& folder);

/// Removes an export folder in one step, with what engines wrote in it. A link is not followed.
///
/// Errors: BadInput if it is a link; Edited if a file in it was modified or is not part of the export; Io; Cancelled.
/// The folder is unchanged then.
Status removeExportFolder(const std::filesystem::path& folder, const TaskContext& task = {},
                          FolderLocking locking = FolderLocking::Here);

}  // namespace rubble
