#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace rubble {

/// The number of letters to insert, delete, replace or exchange with the next one, so that one word becomes the other.
/// No letter is edited twice: the optimal string alignment distance.
std::size_t editDistance(std::string_view first, std::string_view second);

/// Returns the name that was probably meant by a mistyped one: the nearest by editDistance(), if at most a third of its
/// letters differ, or else the only one that starts with it. The first of several that are as near.
std::optional<std::string> suggestionFor(std::string_view typed, std::span<const std::string> names);

}  // namespace rubble
