#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace rubble {

/// The limit below which the index of two numbers fits in 32 bits.
inline constexpr std::uint32_t kMaxPairNumber = 10'000;

/// Enumerates all pairs in growing squares, so that the cell of a column and a row keeps its index when columns or rows
/// are added.
/// Source: Rosenberg, Strong, "Addressing arrays by shells", 1972.
inline std::uint32_t pairIndex(std::uint32_t first, std::uint32_t second) {
    return first < second ? second * second + first : first * first + first + second;
}

/// Maps 0, -1, 1, -2, … to 0, 1, 2, 3, …
inline std::uint32_t zigzag(int number) {
    return number < 0 ? static_cast<std::uint32_t>(-2 * number - 1) : static_cast<std::uint32_t>(2 * number);
}

/// The inverse of zigzag().
inline int zigzagged(std::uint32_t number) {
    const int half = static_cast<int>(number / 2);
    return number % 2 == 0 ? half : -half - 1;
}

struct IndexPair {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    std::uint32_t index() const { return pairIndex(first, second); }
};

/// All pairs below two limits, ascending by index.
inline std::vector<IndexPair> pairsBelow(std::uint32_t firsts, std::uint32_t seconds) {
    std::vector<IndexPair> pairs;
    pairs.reserve(std::size_t{firsts} * seconds);
    for (std::uint32_t side = 0; side < std::max(firsts, seconds); ++side) {
        if (side < seconds) {
            for (std::uint32_t first = 0; first < std::min(side, firsts); ++first) pairs.push_back({first, side});
        }
        if (side < firsts) {
            for (std::uint32_t second = 0; second < std::min(side + 1, seconds); ++second) {
                pairs.push_back({side, second});
            }
        }
    }
    return pairs;
}

/// The limit below which the index of three numbers fits in 32 bits.
inline constexpr std::uint32_t kMaxTripleNumber = 1'600;

/// Enumerates all triples in growing cubes, as pairIndex() does pairs.
inline std::uint32_t tripleIndex(std::uint32_t first, std::uint32_t second, std::uint32_t third) {
    const std::uint32_t side = std::max({first, second, third}), cube = side * side * side;
    if (third == side) return cube + pairIndex(first, second);
    return cube + (side + 1) * (side + 1) + third * (2 * side + 1) + pairIndex(first, second) - side * side;
}

}  // namespace rubble
