#pragma once

#include <string>
#include <string_view>

namespace rubble {

/// Appends text as a JSON string with its quotes. Escapes '"', '\' and control characters; bytes that are not UTF-8, as
/// paths can hold, become U+FFFD.
void appendJsonText(std::string& json, std::string_view text);

}  // namespace rubble
