#pragma once

#include <string>
#include <string_view>

namespace rubble {

/// Appends text (UTF-8) as a JSON string with its quotes. Escapes '"', '\' and control characters.
void appendJsonText(std::string& json, std::string_view text);

}  // namespace rubble
