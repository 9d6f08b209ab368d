#pragma once

#include "core/base/Result.h"

#include <filesystem>

namespace rubble {

/// Return errors with the path and the system's reason for a value of errno: `Cannot write "a/b": Permission denied.`
/// An error of reading is NotFound where the file is missing, else Io.
Error cannotWrite(const std::filesystem::path& path, int code);
Error cannotRead(const std::filesystem::path& path, int code);
/// The same with another verb: `Cannot lock "a/b": ...`.
Error cannotDo(const char* verb, const std::filesystem::path& path, int code);

/// Returns an error about a file, after what could not be done: `Cannot read "a/b": ...`.
Error withPath(const char* what, const std::filesystem::path& path, const Error& error);

/// Returns an error about `path`, a temporary file that the user does not know, that names `shown` instead.
Error namedAs(const std::filesystem::path& shown, const std::filesystem::path& path, Error error);

}  // namespace rubble
