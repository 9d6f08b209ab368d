#pragma once

#include <cstdint>
#include <span>

namespace rubble {

/// A key in the upper 32 bits, an index in the lower ones.
using Keyed = std::uint64_t;
constexpr Keyed keyed(std::uint32_t key, std::uint32_t index) { return Keyed{key} << 32 | index; }
constexpr std::uint32_t keyOf(Keyed entry) { return static_cast<std::uint32_t>(entry >> 32); }
constexpr std::uint32_t indexOf(Keyed entry) { return static_cast<std::uint32_t>(entry); }

/// Sorts entries by the `width` lowest bits of their keys; those of equal keys stay in their order. Gives where they end up: there
/// or in `other`, which is as long. Takes time in proportion to their number, digit by digit (radix sort).
std::span<Keyed> sortByKey(std::span<Keyed> entries, std::span<Keyed> other, int width);

/// How many bits of a key a digit has at most.
inline constexpr int kKeyDigitBits = 8;

}  // namespace rubble
