#pragma once

#include <optional>
#include <string_view>

namespace rubble {

/// Returns a text without spaces at its start and end.
std::string_view trimmed(std::string_view text);

/// Takes the next word, without spaces, off the start of a text; empty at its end.
std::string_view takeWord(std::string_view& text);

/// Returns the number that a word is, as all of it; "nan" and "inf" are numbers.
std::optional<double> numberOf(std::string_view word);

/// Returns whether two texts are equal but for the case of ASCII letters.
bool isSameWord(std::string_view a, std::string_view b);

}  // namespace rubble
