#pragma once

#include <string>

namespace rubble {

/// Returns `name` as a file name that is valid on every system: all ASCII but letters, digits, '-', '_', '.' and ' '
/// becomes '_', as does a '.' or ' ' at either end. Never empty.
std::string safeFileName(const std::string& name);

}  // namespace rubble
