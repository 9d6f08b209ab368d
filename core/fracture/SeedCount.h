#pragma once

#include <cstdint>

namespace rubble {

/// By what it is told how many seeds a layer throws.
enum class CountBy {
    Number,     // so many
    Density,    // so many a square metre
    PieceSize,  // as many as make pieces of a size on average
};

/// How many seeds a layer throws: a number, or as many as follow from the area that it fills, so that outlines of all sizes
/// get pieces of one size.
struct SeedCount {
    CountBy by = CountBy::Number;
    double amount = 20.0;  // whole; 1/m^2, > 0; m, > 0: the side of a square that is as large as a piece

    constexpr SeedCount() = default;
    constexpr SeedCount(std::uint32_t number) : amount(number) {}
    constexpr SeedCount(CountBy kind, double value) : by(kind), amount(value) {}

    /// A whole number, one at least unless it is told by number; infinite where it is beyond doubles.
    double in(double area) const;
    bool operator==(const SeedCount&) const = default;
};

}  // namespace rubble
