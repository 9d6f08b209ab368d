#include "core/io/text/NumberText.h"

#include "core/base/Assert.h"

#include <charconv>
#include <cmath>

namespace rubble {

char* writeNumber(char* at, double value) {
    RUBBLE_ASSERT(std::isfinite(value));
    return std::to_chars(at, at + kMaxNumberLength, value + 0.0).ptr;  // -0 + 0 is 0
}

char* writeLargeInteger(char* at, std::uint64_t value) {
    char* const end = at + kMaxNumberLength;
    const auto low = static_cast<std::uint32_t>(value);  // almost always all of it, and faster to divide
    return (low == value ? std::to_chars(at, end, low) : std::to_chars(at, end, value)).ptr;
}

void appendNumber(std::string& text, double value) {
    char number[kMaxNumberLength];
    text.append(number, writeNumber(number, value));
}

void appendNumber(std::string& text, std::uint32_t value) {
    char number[kMaxNumberLength];
    text.append(number, writeInteger(number, value));
}

void appendFloat(std::string& text, double value) {
    const auto rounded = static_cast<float>(value);
    RUBBLE_ASSERT(std::isfinite(rounded));
    char number[kMaxNumberLength];
    text.append(number, std::to_chars(number, number + kMaxNumberLength, rounded + 0.0f).ptr);
}

std::string numberText(double value) {
    std::string text;
    appendNumber(text, value);
    return text;
}

}  // namespace rubble
