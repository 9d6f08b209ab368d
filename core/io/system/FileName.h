#pragma once

#include <string>

namespace rubble {

/// Returns `name` as a file name that is valid on every system: all ASCII characters except letters, digits, '-', '_',
/// '.' and ' ' become '_', as does a '.' or ' ' at either end. Never empty. One of more than 200 bytes, which would
/// leave no room for endings, is shortened and gets a hash of the whole.
std::string safeFileName(const std::string& name);

/// Returns `start`, `name` and `end` as one file name. One of more than 255 bytes, the limit of Linux file systems,
/// gets a shortened name with a hash of the whole.
std::string fittingFileName(const std::string& start, const std::string& name, const std::string& end);

}  // namespace rubble
