#include "core/base/MessageText.h"

#include <array>
#include <charconv>
#include <cmath>

namespace rubble {

std::string messageText(double value) {
    std::array<char, 32> text;  // the longest has 25 characters
    const double size = std::abs(value);
    const bool isPlain = size == 0.0 || (size >= 1e-6 && size < 1e15);
    const std::to_chars_result result =
        isPlain ? std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed)
                : std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), result.ptr};
}

std::string roundedText(double value, int digits) {
    std::array<char, 32> text;
    const std::to_chars_result result =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
    return {text.data(), result.ptr};
}

}  // namespace rubble
