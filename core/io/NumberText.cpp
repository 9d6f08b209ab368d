#include "core/io/NumberText.h"

#include "core/base/Assert.h"

#include <charconv>
#include <cmath>

namespace rubble {

char* writeNumber(char* at, double value) {
    RUBBLE_ASSERT(std::isfinite(value));
    return std::to_chars(at, at + kLongestNumberText, value + 0.0).ptr;  // -0 + 0 is 0
}

char* writeNumber(char* at, std::uint32_t value) { return std::to_chars(at, at + kLongestNumberText, value).ptr; }

void appendNumber(std::string& text, double value) {
    char number[kLongestNumberText];
    text.append(number, writeNumber(number, value));
}

void appendNumber(std::string& text, std::uint32_t value) {
    char number[kLongestNumberText];
    text.append(number, writeNumber(number, value));
}

}  // namespace rubble
