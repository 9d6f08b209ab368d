#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace rubble::test {

/// The cyclic redundancy check of PNG, of a chunk's type and data.
/// Source: Portable Network Graphics (PNG) Specification, W3C, 2003, annex D.
inline std::uint32_t pngChecksum(std::string_view bytes) {
    std::uint32_t sum = 0xffffffffu;
    for (const char byte : bytes) {
        sum ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) sum = (sum >> 1u) ^ ((sum & 1u) != 0 ? 0xedb88320u : 0u);
    }
    return ~sum;
}

/// A damaged PNG file with the checksums of its chunks made right, so that a reader gets to see the damage.
inline std::string withPngChecksums(std::string bytes) {
    constexpr std::size_t kSignature = 8, kBeforeType = 4, kType = 4, kChecksum = 4;
    const auto number = [&](std::size_t at) {
        std::uint32_t value = 0;
        for (std::size_t k = 0; k < 4; ++k) value = value << 8u | static_cast<unsigned char>(bytes[at + k]);
        return value;
    };
    std::size_t at = kSignature;
    while (at + kBeforeType + kType + kChecksum <= bytes.size()) {
        const std::size_t left = bytes.size() - at - kBeforeType - kType - kChecksum;
        const std::size_t size = kType + number(at);
        if (size > kType + left) break;
        const std::size_t type = at + kBeforeType;
        const std::uint32_t sum = pngChecksum(std::string_view(bytes).substr(type, size));
        for (std::size_t k = 0; k < 4; ++k) bytes[type + size + k] = static_cast<char>(sum >> (24u - 8u * k));
        at = type + size + kChecksum;
    }
    return bytes;
}

}  // namespace rubble::test
