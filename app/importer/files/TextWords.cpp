#include "app/importer/files/TextWords.h"

#include <algorithm>
#include <charconv>

namespace rubble {
namespace {

constexpr std::string_view kSpaces = " \t\r\n\v\f";

char lower(char letter) { return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter; }

}  // namespace

std::string_view trimmed(std::string_view text) {
    text.remove_prefix(std::min(text.find_first_not_of(kSpaces), text.size()));
    return text.substr(0, text.find_last_not_of(kSpaces) + 1);
}

std::string_view takeWord(std::string_view& text) {
    text.remove_prefix(std::min(text.find_first_not_of(kSpaces), text.size()));
    const std::string_view word = text.substr(0, text.find_first_of(kSpaces));
    text.remove_prefix(word.size());
    return word;
}

std::optional<double> numberOf(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    double number = 0.0;
    const auto read = std::from_chars(word.data(), word.data() + word.size(), number);
    const bool isTiny = read.ec == std::errc::result_out_of_range && word.find("e-") != std::string_view::npos;
    if (isTiny) number = 0.0;
    if ((read.ec != std::errc{} && !isTiny) || read.ptr != word.data() + word.size()) return std::nullopt;
    return number;
}

bool isSameWord(std::string_view a, std::string_view b) { return std::ranges::equal(a, b, {}, lower, lower); }

}  // namespace rubble
