#pragma once

#include <string>
#include <string_view>

namespace rubble {

/// Appends text as a JSON string, quotes included: '"', '\' and control characters escaped, all else (UTF-8) as it is.
void appendJsonText(std::string& json, std::string_view text);

}  // namespace rubble
