#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace rubble {

/// Returns a URI with its escapes, "%20", decoded once. Nothing if it has none, or one that is invalid or stands for a
/// null character.
std::optional<std::string> percentDecoded(std::string_view uri);

}  // namespace rubble
