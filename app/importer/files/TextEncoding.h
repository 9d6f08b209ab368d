#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rubble {

/// Returns a text as UTF-8 without a byte order mark if its bytes begin with the mark of UTF-8 or UTF-16 and an ASCII
/// character; nothing otherwise. What is not valid UTF-16 becomes U+FFFD.
std::optional<std::string> utf8Text(std::string_view bytes);

}  // namespace rubble
