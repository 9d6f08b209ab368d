#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace rubble {

/// What a character of a name is to file systems.
enum class NameCharacter {
    Visible,
    Space,
    Invisible,  // controls, format characters as of direction and width, line separators, unassigned, private, no text
};

/// The kind of a code point, by its general category in Unicode 14.
NameCharacter nameCharacterOf(char32_t code);

/// The code points of a text in normalization form C; U+FFFD for each byte that is not part of well-formed UTF-8.
std::u32string composedCodePoints(std::string_view text);

/// The UTF-8 of code points.
std::string utf8Of(std::u32string_view codes);

/// The length of a name as the strictest file system counts it: bytes in UTF-8 or, if these are more, UTF-16 units in
/// normalization form D, in which HFS+ keeps names.
std::size_t nameLength(std::string_view text);

/// The key of a name. File systems that ignore case, normalization or invisible characters take two names for one only
/// if their keys are equal; names that are merely compatible, such as "x²" and "x2", have equal keys, too.
/// Source: Unicode 14, section 3.13, toNFKC_Casefold, of the name and of the name in upper case.
std::string nameKey(std::string_view text);

}  // namespace rubble
