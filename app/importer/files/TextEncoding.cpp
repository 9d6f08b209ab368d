#include "app/importer/files/TextEncoding.h"

#include <cstddef>
#include <cstdint>

namespace rubble {
namespace {

constexpr char32_t kReplacement = 0xfffd;

bool isHighSurrogate(char32_t unit) { return unit >= 0xd800 && unit < 0xdc00; }
bool isLowSurrogate(char32_t unit) { return unit >= 0xdc00 && unit < 0xe000; }
bool isAscii(char32_t code) { return code > 0 && code < 0x80; }

void append(std::string& text, char32_t code) {
    const auto add = [&](char32_t byte) { text += static_cast<char>(byte); };
    if (code < 0x80) return add(code);
    if (code < 0x800) {
        add(0xc0 | code >> 6);
    } else if (code < 0x10000) {
        add(0xe0 | code >> 12);
        add(0x80 | (code >> 6 & 0x3f));
    } else {
        add(0xf0 | code >> 18);
        add(0x80 | (code >> 12 & 0x3f));
        add(0x80 | (code >> 6 & 0x3f));
    }
    add(0x80 | (code & 0x3f));
}

/// The 16-bit units of a text.
class Utf16 {
public:
    Utf16(std::string_view bytes, std::size_t highByte) : m_bytes(bytes), m_highByte(highByte) {}
    std::size_t size() const { return m_bytes.size() / 2; }
    char32_t operator[](std::size_t i) const { return byte(2 * i + m_highByte) << 8 | byte(2 * i + 1 - m_highByte); }

private:
    char32_t byte(std::size_t i) const { return static_cast<unsigned char>(m_bytes[i]); }

    std::string_view m_bytes;
    std::size_t m_highByte;  // 0 if it comes first
};

std::string converted(const Utf16& units) {
    std::string text;
    text.reserve(units.size());
    for (std::size_t i = 0; i < units.size(); ++i) {
        char32_t code = units[i];
        if (isHighSurrogate(code) && i + 1 < units.size() && isLowSurrogate(units[i + 1])) {
            code = 0x10000 + ((code - 0xd800) << 10) + (units[++i] - 0xdc00);
        } else if (isHighSurrogate(code) || isLowSurrogate(code)) {
            code = kReplacement;
        }
        append(text, code);
    }
    return text;
}

}  // namespace

std::optional<std::string> utf8Text(std::string_view bytes) {
    constexpr std::string_view kUtf8Mark = "\xef\xbb\xbf";
    if (bytes.starts_with(kUtf8Mark)) {
        bytes.remove_prefix(kUtf8Mark.size());
        const bool isText = !bytes.empty() && isAscii(static_cast<unsigned char>(bytes[0]));
        return isText ? std::optional(std::string(bytes)) : std::nullopt;
    }
    const bool isBigEndian = bytes.starts_with("\xfe\xff");
    if (!isBigEndian && !bytes.starts_with("\xff\xfe")) return std::nullopt;
    const Utf16 units(bytes.substr(2), isBigEndian ? 0 : 1);
    if (units.size() == 0 || !isAscii(units[0])) return std::nullopt;
    return converted(units);
}

}  // namespace rubble
