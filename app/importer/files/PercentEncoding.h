#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rubble {

/// Returns a URI with its escapes, "%20", decoded once. Nothing if it has none, or one that is invalid or stands for a
/// null character.
std::optional<std::string> percentDecoded(std::string_view uri);

/// Returns the bytes of base64 text, which may lack its padding. Nothing if it has other characters.
std::optional<std::string> base64Decoded(std::string_view text);

}  // namespace rubble
