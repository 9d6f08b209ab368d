#include "app/cli/console/PrintableText.h"

#include "core/base/Utf8.h"

#include <algorithm>
#include <cstdio>

namespace rubble {
namespace {

/// The number of bytes of a character by its first one; 1 for a byte that starts none.
std::size_t lengthOf(unsigned char first) {
    if (first >= 0xf0) return 4;
    if (first >= 0xe0) return 3;
    return first >= 0xc2 ? 2 : 1;
}

/// Decodes a well-formed character of UTF-8.
char32_t codePointOf(std::string_view character) {
    const auto first = static_cast<unsigned char>(character[0]);
    char32_t code = character.size() == 1 ? first : first & (0x7fu >> character.size());
    for (const char byte : character.substr(1)) code = code << 6 | (static_cast<unsigned char>(byte) & 0x3fu);
    return code;
}

bool isControl(char32_t code) {
    if (code < 0x20) return code != '\n' && code != '\t';
    const bool isHighControl = code >= 0x7f && code < 0xa0;
    const bool isDirection = (code >= 0x202a && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
    return isHighControl || isDirection;
}

std::string escaped(const char* format, unsigned code) {
    char text[16];
    std::snprintf(text, sizeof text, format, code);
    return text;
}

}  // namespace

std::string printableText(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const auto first = static_cast<unsigned char>(text[0]);
        if (first >= 0x20 && first < 0x7f) {
            result += text[0];
            text.remove_prefix(1);
            continue;
        }
        const std::string_view character = text.substr(0, lengthOf(first));
        if (!isUtf8(character)) {
            result += escaped("\\x%02x", first);
            text.remove_prefix(1);
            continue;
        }
        const char32_t code = codePointOf(character);
        result += isControl(code) ? escaped("\\u%04x", static_cast<unsigned>(code)) : std::string(character);
        text.remove_prefix(character.size());
    }
    return result;
}

PrintableBuffer::int_type PrintableBuffer::overflow(int_type letter) {
    if (traits_type::eq_int_type(letter, traits_type::eof())) return 0;
    m_text += traits_type::to_char_type(letter);
    return letter;
}

int PrintableBuffer::sync() {
    m_target << printableText(m_text) << std::flush;
    m_text.clear();
    return m_target ? 0 : -1;
}

}  // namespace rubble
