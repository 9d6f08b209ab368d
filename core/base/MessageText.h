#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace rubble {

/// A number for a message: the shortest text that parses to the same number, NaN and infinity included, in any locale.
/// Without an exponent from 1e-6 up to 1e15.
std::string messageText(double value);

/// A number with 1 to 17 significant digits.
std::string roundedText(double value, int digits);

/// Returns text that cannot control a terminal or mislead a reader: control characters except line feeds and tabs,
/// Unicode direction marks and separators, and bytes that are not UTF-8 become "\\u001b" or "\\x9b". Printable text
/// stays as it is.
std::string printableText(std::string_view text);

/// Returns a name for a sentence: printable, on one line, at most 60 characters. A longer one loses its middle: names
/// in files can have any length.
std::string shownName(std::string_view name);

/// Returns shownName() in double quotes.
std::string quotedName(std::string_view name);

/// Returns quoted names for a sentence: `"a", "b" and 97 more`, at most 20 of them.
std::string quotedNames(const std::vector<std::string>& names);

/// Returns a path for a sentence: quoted, printable, whole.
std::string quotedPath(const std::filesystem::path& path);

}  // namespace rubble
