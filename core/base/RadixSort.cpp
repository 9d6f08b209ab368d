#include "core/base/RadixSort.h"

#include <algorithm>
#include <array>
#include <utility>

namespace rubble {

std::span<KeyedIndex> radixSortByKey(std::span<KeyedIndex> entries, std::span<KeyedIndex> scratch, int width) {
    // Digits of equal size, as small as the number of passes allows: for few entries, clearing the counters dominates.
    const int passes = (width + kMaxDigitBits - 1) / kMaxDigitBits,
              bits = passes > 0 ? (width + passes - 1) / passes : 0;
    const std::size_t digits = std::size_t{1} << bits;
    for (int pass = 0; pass < passes; ++pass) {
        const auto digit = [&](KeyedIndex entry) { return entry >> (32 + pass * bits) & (digits - 1); };
        std::array<std::uint32_t, (std::size_t{1} << kMaxDigitBits) + 1> starts;
        std::fill_n(starts.begin(), digits + 1, 0u);
        for (const KeyedIndex entry : entries) ++starts[digit(entry) + 1];
        for (std::size_t i = 1; i <= digits; ++i) starts[i] += starts[i - 1];
        for (const KeyedIndex entry : entries) scratch[starts[digit(entry)]++] = entry;
        std::swap(entries, scratch);
    }
    return entries;
}

}  // namespace rubble
