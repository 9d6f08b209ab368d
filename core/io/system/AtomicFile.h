#pragma once

#include "core/base/Result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace rubble {

/// Writes a file atomically: to a temporary file beside it, flushed to disk, then renamed over it. On an error the old
/// file is unchanged and the temporary one removed. Symbolic links and permissions are kept. Devices and pipes are
/// written directly.
///
/// Errors: Io, with the path and the system's reason.
Status writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

/// Returns the contents of a file.
///
/// Errors, with the path: NotFound; Io; Limit above 1 GiB.
Result<std::string> readFile(const std::filesystem::path& path);

}  // namespace rubble
