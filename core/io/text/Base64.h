#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rubble {

/// Bytes as base64 text with padding.
/// Source: RFC 4648.
std::string base64(std::string_view bytes);

/// Returns the bytes of base64 text, also in the alphabet of URLs, which may lack its padding. Nothing if it has other
/// characters.
std::optional<std::string> base64Decoded(std::string_view text);

}  // namespace rubble
