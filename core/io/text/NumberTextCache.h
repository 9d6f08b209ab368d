#pragma once

#include "core/io/text/NumberText.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

namespace rubble {

/// Caches the texts of recent numbers: the same coordinates occur many times in a file.
class NumberTextCache {
public:
    /// Does the same as writeNumber().
    char* write(char* at, double value) {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        Entry& entry = m_entries[(bits * 0x9e3779b97f4a7c15u) >> (64 - kEntryBits)];  // multiplicative hash
        if (entry.bits != bits || entry.length == 0) entry.set(bits, value);
        std::memcpy(at, entry.text, kMaxNumberLength);  // a fixed size is a few moves
        return at + entry.length;
    }

private:
    static constexpr unsigned kEntryBits = 8;  // 10 KiB, which fit into the L1 cache
    struct Entry {
        std::uint64_t bits = 0;
        std::uint8_t length = 0;  // 0: empty
        char text[kMaxNumberLength];

        void set(std::uint64_t newBits, double value) {
            bits = newBits;
            length = static_cast<std::uint8_t>(writeNumber(text, value) - text);
        }
    };
    std::array<Entry, 1u << kEntryBits> m_entries{};
};

}  // namespace rubble
