#pragma once

#include <cstdint>

namespace rubble {

/// The quantity that determines a seed count.
enum class CountBy {
    Number,        // a number of seeds
    Density,       // seeds per square metre
    FragmentSize,  // the mean size of pieces
};

/// The number of seeds that a layer scatters: fixed, or in proportion to the area, so that outlines of any size get
/// pieces of the same size.
struct SeedCount {
    CountBy by = CountBy::Number;
    double amount = 20.0;  // a whole number; 1/m², > 0; m, > 0: the side of a square of the mean area

    constexpr SeedCount() = default;
    constexpr SeedCount(std::uint32_t number) : amount(number) {}
    constexpr SeedCount(CountBy kind, double value) : by(kind), amount(value) {}

    /// The number of seeds for an area in m²: whole, at least 1 unless given by Number; may be infinite.
    double in(double area) const;
    bool operator==(const SeedCount&) const = default;
};

}  // namespace rubble
