#pragma once

#include <string_view>

namespace rubble {

/// Whether text is well-formed UTF-8: no overlong forms, no surrogates, nothing above U+10FFFF.
/// Source: Unicode 15, table 3-7.
bool isUtf8(std::string_view text);

}  // namespace rubble
