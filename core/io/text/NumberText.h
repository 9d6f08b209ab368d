#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace rubble {

/// The maximum length of a number's text: "-2.2250738585072014e-308".
inline constexpr std::size_t kMaxNumberLength = 24;

/// Writes the shortest decimal text that reads back as the same double: "0.1", "1e-07", never "-0". The same bytes in
/// every locale, valid in JSON and OBJ. `at` has room for kMaxNumberLength characters; returns the end of the text,
/// which is not null-terminated. The value must be finite.
char* writeNumber(char* at, double value);
/// The same for an integer >= 0.
char* writeLargeInteger(char* at, std::uint64_t value);
inline char* writeInteger(char* at, std::uint64_t value) {
    if (value >= 100) return writeLargeInteger(at, value);  // most indices are smaller
    if (value >= 10) *at++ = static_cast<char>('0' + value / 10);
    *at++ = static_cast<char>('0' + value % 10);
    return at;
}

/// Returns the text of writeNumber() as a string.
std::string numberText(double value);
/// Appends the same text to a string.
void appendNumber(std::string& text, double value);
void appendNumber(std::string& text, std::uint32_t value);
/// Appends the shortest text that reads back as the float nearest to `value`, which is in the range of floats; never
/// "-0".
void appendFloat(std::string& text, double value);

}  // namespace rubble
