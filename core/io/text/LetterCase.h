#pragma once

#include <algorithm>
#include <string>

namespace rubble {

/// The text with small letters of ASCII instead of capitals; all others stay.
inline std::string lowerCase(std::string text) {
    std::ranges::transform(text, text.begin(), [](char letter) {
        return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
    });
    return text;
}

}  // namespace rubble
