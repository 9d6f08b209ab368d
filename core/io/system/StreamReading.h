#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"

#include <filesystem>
#include <string>

namespace rubble {

/// Returns all that can be read from a descriptor up to its end, waiting for it. A cancelled task stops waiting.
///
/// Errors, with `name`: Io; Limit above 1 GiB; Cancelled.
Result<std::string> readStream(int descriptor, const std::filesystem::path& name, const CancelToken& cancel);

/// Returns the contents of a file, pipe or device, as readStream().
///
/// Errors: those of readStream(); NotFound.
Result<std::string> readFileOrStream(const std::filesystem::path& path, const CancelToken& cancel);

}  // namespace rubble
