#pragma once

#include "core/io/NumberText.h"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace rubble {

/// Texts of numbers that were written before: solids say the same coordinate many times.
class NumberCache {
public:
    /// As writeNumber().
    char* write(char* at, double value) {
        const auto bits = std::bit_cast<std::uint64_t>(value);
        Entry& entry = m_entries[(bits * 0x9e3779b97f4a7c15u) >> (64 - kEntryBits)];
        if (entry.bits != bits || entry.length == 0) {
            entry.bits = bits;
            entry.length = static_cast<std::uint8_t>(writeNumber(entry.text, value) - entry.text);
        }
        std::memcpy(at, entry.text, kLongestNumberText);  // always all: that is a few fixed moves
        return at + entry.length;
    }

private:
    static constexpr unsigned kEntryBits = 8;  // 10 KiB: stays in the nearest cache
    struct Entry {
        std::uint64_t bits = 0;
        std::uint8_t length = 0;  // 0: empty
        char text[kLongestNumberText];
    };
    std::array<Entry, 1u << kEntryBits> m_entries{};
};

/// Writes JSON without blanks into memory that is large enough, which the caller has seen to.
class PackText {
public:
    explicit PackText(char* start) : m_at(start) {}

    void raw(std::string_view text) {
        std::memcpy(m_at, text.data(), text.size());
        m_at += text.size();
    }
    void raw(char letter) { *m_at++ = letter; }
    void number(double value) { m_at = m_numbers.write(m_at, value); }
    void index(std::uint32_t value) {
        if (value >= 100) {
            m_at = writeNumber(m_at, value);
            return;
        }
        if (value >= 10) *m_at++ = static_cast<char>('0' + value / 10);
        *m_at++ = static_cast<char>('0' + value % 10);
    }
    /// [a,b,...]: each element by `write`.
    template <class Elements, class Write>
    void list(const Elements& elements, Write write) {
        raw('[');
        bool isFirst = true;
        for (const auto& element : elements) {
            if (!isFirst) raw(',');
            isFirst = false;
            write(element);
        }
        raw(']');
    }
    const char* end() const { return m_at; }

private:
    char* m_at;
    NumberCache m_numbers;
};

}  // namespace rubble
