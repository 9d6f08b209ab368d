#pragma once

#include <string>
#include <string_view>

namespace rubble {

/// Whether text is well-formed UTF-8: no overlong forms, no surrogates, nothing above U+10FFFF.
/// Source: Unicode 15, table 3-7.
bool isUtf8(std::string_view text);

/// Returns the text with U+FFFD in place of each byte that is not part of well-formed UTF-8.
std::string wellFormed(std::string_view text);

}  // namespace rubble
