#pragma once

#include "core/base/Result.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace rubble {

/// Writes a whole file or nothing: to a temporary file beside it, flushed to disk, then renamed over it. On a fault the
/// old file stays as it was and the temporary one is removed. A link stays a link, permissions are kept; a device or a
/// pipe is written to as it is.
///
/// Errors: Io, with the path and the system's reason.
Status writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

/// A file's bytes.
///
/// Errors: NotFound, Io, Limit (above 1 GiB), with the path.
Result<std::string> readFile(const std::filesystem::path& path);

}  // namespace rubble
