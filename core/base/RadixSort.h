#pragma once

#include <cstdint>
#include <span>

namespace rubble {

/// A key in the upper 32 bits, an index in the lower 32.
using KeyedIndex = std::uint64_t;
constexpr KeyedIndex keyedIndex(std::uint32_t key, std::uint32_t index) { return KeyedIndex{key} << 32 | index; }
constexpr std::uint32_t keyOf(KeyedIndex entry) { return static_cast<std::uint32_t>(entry >> 32); }
constexpr std::uint32_t indexOf(KeyedIndex entry) { return static_cast<std::uint32_t>(entry); }

/// Stable LSD radix sort of entries by the `width` lowest bits of their keys. `scratch` must have the same size.
/// Returns the sorted entries, which are in either span. O(n) for a given width.
std::span<KeyedIndex> radixSortByKey(std::span<KeyedIndex> entries, std::span<KeyedIndex> scratch, int width);

/// The maximum number of bits per digit.
inline constexpr int kMaxDigitBits = 8;

}  // namespace rubble
