#pragma once

#include "core/base/Hash.h"
#include "core/base/Result.h"
#include "core/base/TaskContext.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace rubble {

/// A file of an export, its name without folders.
struct ExportFile {
    std::string name;
    std::string bytes;
};

/// The name of the list that every export folder holds: what it was made from, and name, size and hash of each file.
inline constexpr const char* kManifestName = "manifest.json";

/// True where the folder is a whole, unaltered export of `source`: the manifest says so and every file is as it lists it.
/// Reads all files.
bool isExportOf(const std::filesystem::path& folder, const ContentHash& source);

/// Says what is wrong with an export: a manifest that is missing or unreadable, a file that is missing or not as it was
/// exported, something that no export wrote. Nothing where all is well. Reads all files.
std::optional<std::string> verifyExportFolder(const std::filesystem::path& folder);

/// Puts an export in place as a whole: into a hidden folder beside `folder`, then renamed. An earlier export is moved aside
/// and removed; on a fault, or when cancelled, it stays as it was and nothing is left behind. Folders above are made.
///
/// Errors: Io, with the path and the system's reason; BadInput where the folder holds what no export wrote, naming one such
/// file; Cancelled.
Status writeExportFolder(const std::filesystem::path& folder, const ContentHash& source,
                         std::span<const ExportFile> files, const TaskContext& task = {});

/// A name for a folder or file that every system takes: letters, digits, '-', '_', '.', ' ' and what is not ASCII stay, all
/// else becomes '_', as does a '.' or ' ' at either end. Never empty.
std::string safeFileName(const std::string& name);

}  // namespace rubble
