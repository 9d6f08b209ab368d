#pragma once

#include "core/base/Result.h"

#include <filesystem>
#include <vector>

namespace rubble {

/// Returns the entries of a folder ("": the current one), hidden ones included, in no order. Unlike a loop over a
/// directory_iterator it does not throw.
///
/// Errors, with the path: NotFound; Io.
Result<std::vector<std::filesystem::directory_entry>> entriesOf(const std::filesystem::path& folder);

/// Whether a path is a symbolic link; false where it cannot be read.
bool isLink(const std::filesystem::path& path);

}  // namespace rubble
