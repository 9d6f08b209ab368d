#include "core/base/MessageText.h"

#include <array>
#include <charconv>

namespace rubble {

std::string messageText(double value) {
    std::array<char, 32> text;  // the longest shortest text of a double has 24 characters
    const std::to_chars_result result = std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), result.ptr};
}

std::string roundedText(double value, int digits) {
    std::array<char, 32> text;
    const std::to_chars_result result =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, digits);
    return {text.data(), result.ptr};
}

}  // namespace rubble
