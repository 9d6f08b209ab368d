#pragma once

#include <string>

namespace rubble {

/// Returns `name` as a file name that is valid on every system: all ASCII characters except letters, digits, '-', '_',
/// '.' and ' ' become '_', as does a '.' or ' ' at either end. Never empty.
std::string safeFileName(const std::string& name);

}  // namespace rubble
