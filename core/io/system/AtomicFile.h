#pragma once

#include "core/base/Result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace rubble {

/// Writes a file atomically: to a temporary file beside it, flushed to disk, then renamed over it. On an error the old
/// file is unchanged and the temporary one removed. Symbolic links, owner and permissions are kept. Devices and pipes
/// are written directly.
///
/// A file with several hard links, an access control list or an owner that cannot be given to a new file is written in
/// place, after a copy of it: see copyBeforeSave().
///
/// Errors: Io, with the path and the system's reason.
Status writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

/// Returns what a path leads to if it is a symbolic link, whether it exists or not; else the path.
std::filesystem::path linkTarget(std::filesystem::path path);

/// Returns the path of the copy that exists while a file is written in place: "house.rubble.before-save". It stays if
/// the process is killed meanwhile.
std::filesystem::path copyBeforeSave(const std::filesystem::path& path);

/// Returns the contents of a regular file. Never waits: pipes and devices are refused.
///
/// Errors, with the path: NotFound; Io; Limit above 1 GiB.
Result<std::string> readFile(const std::filesystem::path& path);

}  // namespace rubble
