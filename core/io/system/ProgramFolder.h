#pragma once

#include <filesystem>

namespace rubble {

/// Returns the absolute folder of the running program, never that of a program of the same name in the current folder
/// or in PATH: from /proc or, where that is not mounted, from the path with which the kernel started the program. Empty
/// if neither exists.
std::filesystem::path programFolder();

/// Returns the folder of what `link` links to or, if there is no such link, of `startedAs`, with symbolic links
/// resolved. Empty if neither exists.
std::filesystem::path folderOfProgram(const std::filesystem::path& link, const std::filesystem::path& startedAs);

}  // namespace rubble
