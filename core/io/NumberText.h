#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace rubble {

/// The most characters that one number takes: "-2.2250738585072014e-308".
inline constexpr std::size_t kLongestNumberText = 24;

/// Writes the shortest decimal text that reads back as the same double: "0.1", "1e-07", never "-0". The same bytes in
/// every locale; good for JSON and OBJ alike. `at` has room for kLongestNumberText; gives the end, without a final zero.
/// The value is finite.
char* writeNumber(char* at, double value);
/// The same for an index or a count.
char* writeNumber(char* at, std::uint32_t value);

/// Appends the same text to a string.
void appendNumber(std::string& text, double value);
void appendNumber(std::string& text, std::uint32_t value);

}  // namespace rubble
