#include "app/importer/files/PercentEncoding.h"

#include <charconv>
#include <cstdint>

namespace rubble {
namespace {

int base64Value(char letter) {
    if (letter >= 'A' && letter <= 'Z') return letter - 'A';
    if (letter >= 'a' && letter <= 'z') return letter - 'a' + 26;
    if (letter >= '0' && letter <= '9') return letter - '0' + 52;
    if (letter == '+' || letter == '-') return 62;
    return letter == '/' || letter == '_' ? 63 : -1;
}

}  // namespace

std::optional<std::string> percentDecoded(std::string_view uri) {
    if (uri.find('%') == std::string_view::npos) return std::nullopt;
    std::string text;
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] != '%') {
            text += uri[i];
            continue;
        }
        unsigned code = 0;
        const std::string_view digits = uri.substr(i + 1, 2);
        const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), code, 16);
        if (digits.size() < 2 || read.ptr != digits.data() + 2 || code == 0) return std::nullopt;
        text += static_cast<char>(code);
        i += 2;
    }
    return text;
}

std::optional<std::string> base64Decoded(std::string_view text) {
    while (text.ends_with('=')) text.remove_suffix(1);
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    int count = 0;
    for (const char letter : text) {
        const int value = base64Value(letter);
        if (value < 0) return std::nullopt;
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        count += 6;
        if (count < 8) continue;
        count -= 8;
        bytes += static_cast<char>(bits >> count & 0xff);
    }
    return bytes;
}

}  // namespace rubble
