#pragma once

#include <filesystem>

namespace rubble::attack {

/// Forbids this process, and those that it starts, to write anything outside a folder. Returns false where the kernel
/// lacks Landlock.
bool confineWrites(const std::filesystem::path& folder);

}  // namespace rubble::attack
