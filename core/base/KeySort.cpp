#include "core/base/KeySort.h"

#include <algorithm>
#include <array>
#include <utility>

namespace rubble {

std::span<Keyed> sortByKey(std::span<Keyed> entries, std::span<Keyed> other, int width) {
    // Digits are of one size and no larger than they need be: of few entries the counters take most of the time.
    const int passes = (width + kKeyDigitBits - 1) / kKeyDigitBits,
              bits = passes > 0 ? (width + passes - 1) / passes : 0;
    const std::size_t digits = std::size_t{1} << bits;
    for (int pass = 0; pass < passes; ++pass) {
        const auto digit = [&](Keyed entry) { return entry >> (32 + pass * bits) & (digits - 1); };
        std::array<std::uint32_t, (std::size_t{1} << kKeyDigitBits) + 1> starts;
        std::fill_n(starts.begin(), digits + 1, 0u);
        for (const Keyed entry : entries) ++starts[digit(entry) + 1];
        for (std::size_t i = 1; i <= digits; ++i) starts[i] += starts[i - 1];
        for (const Keyed entry : entries) other[starts[digit(entry)]++] = entry;
        std::swap(entries, other);
    }
    return entries;
}

}  // namespace rubble
