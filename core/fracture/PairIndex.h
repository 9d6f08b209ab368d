#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

namespace rubble {

/// Pairs of numbers below this have an index that 32 bits hold.
inline constexpr std::uint32_t kMostOfPair = 10'000;

/// Numbers all pairs through, square after square: those of a smaller square come before those of a greater one. So what
/// two growing numbers name, as a grid's columns and rows do, keeps its index whichever of them grows.
inline std::uint32_t pairIndex(std::uint32_t first, std::uint32_t second) {
    return first < second ? second * second + first : first * first + first + second;
}

struct IndexPair {
    std::uint32_t first = 0;
    std::uint32_t second = 0;
    std::uint32_t index() const { return pairIndex(first, second); }
};

/// All pairs below two numbers, ascending by index.
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

}  // namespace rubble
