#pragma once

#include "core/base/Result.h"

#include <filesystem>
#include <vector>

namespace rubble {

/// Whether a folder is a pack, even if pack.json or the manifest is missing. A folder of either name is that of an
/// asset.
bool isPack(const std::filesystem::path& folder);

/// Returns the folder if it is a pack, or the packs in it, sorted by name. Those that are being written, or that killed
/// programs left, are none.
///
/// Errors: NotFound if there is none; those of entriesOf().
Result<std::vector<std::filesystem::path>> packsOf(const std::filesystem::path& folder);

}  // namespace rubble
