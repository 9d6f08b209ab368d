#include "core/base/Utf8.h"

#include <cstddef>

namespace rubble {
namespace {

unsigned byteAt(std::string_view text, std::size_t at) {
    return at < text.size() ? static_cast<unsigned char>(text[at]) : 0u;
}

bool isWithin(unsigned byte, unsigned min, unsigned max) { return byte >= min && byte <= max; }

/// The length in bytes of the character at `at`; 0 if malformed.
std::size_t characterLength(std::string_view text, std::size_t at) {
    const unsigned lead = byteAt(text, at);
    const unsigned second = byteAt(text, at + 1);
    const auto continues = [&](std::size_t offset) { return isWithin(byteAt(text, at + offset), 0x80, 0xbf); };
    if (lead < 0x80) return 1;
    if (isWithin(lead, 0xc2, 0xdf)) return continues(1) ? 2 : 0;
    if (isWithin(lead, 0xe0, 0xef)) {
        const bool isSecond = isWithin(second, lead == 0xe0 ? 0xa0 : 0x80, lead == 0xed ? 0x9f : 0xbf);
        return isSecond && continues(2) ? 3 : 0;
    }
    if (!isWithin(lead, 0xf0, 0xf4)) return 0;
    const bool isSecond = isWithin(second, lead == 0xf0 ? 0x90 : 0x80, lead == 0xf4 ? 0x8f : 0xbf);
    return isSecond && continues(2) && continues(3) ? 4 : 0;
}

}  // namespace

bool isUtf8(std::string_view text) {
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t length = characterLength(text, at);
        if (length == 0) return false;
        at += length;
    }
    return true;
}

std::string wellFormed(std::string_view text) {
    std::string result;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t length = characterLength(text, at);
        result += length == 0 ? std::string_view("\xef\xbf\xbd") : text.substr(at, length);
        at += length == 0 ? 1 : length;
    }
    return result;
}

}  // namespace rubble
