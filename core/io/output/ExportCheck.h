#pragma once

#include "core/base/Hash.h"
#include "core/base/Result.h"

#include <filesystem>
#include <optional>
#include <string>

namespace rubble {

/// Whether the folder is a complete, unmodified export of `source` according to its manifest. Reads all files.
bool isExportOf(const std::filesystem::path& folder, const ContentHash& source);

/// The first fault of an export folder; nothing if there is none: a missing or unreadable manifest, a missing or
/// modified file, an unexpected file, a link, which is not followed. Files that engines write are expected. Reads all
/// files.
std::optional<std::string> verifyExportFolder(const std::filesystem::path& folder);

/// Whether an engine wrote the file beside those that it imports, such as wall.glb.import.
bool isEngineFile(const std::filesystem::directory_entry& entry);

/// The name of a file in the folder that its manifest does not list and no engine wrote, the first by name; nothing if
/// there is none. Errors: Io.
Result<std::optional<std::string>> findUnexpectedFile(const std::filesystem::path& folder);

/// The path of a file of the folder's manifest that was modified; nothing if there is none. Missing files are not.
/// Errors: Io.
Result<std::optional<std::filesystem::path>> findEditedFile(const std::filesystem::path& folder);

}  // namespace rubble
