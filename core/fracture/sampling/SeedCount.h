#pragma once

#include <cstdint>

namespace rubble {

/// Where seeds lie: in an outline, or in a closed mesh.
enum class SeedSpace { Plane, Solid };

/// The quantity that determines a seed count.
enum class CountBy {
    Number,        // a number of seeds
    Density,       // seeds per square metre; in a solid, per cubic metre
    FragmentSize,  // the mean size of pieces
};

/// The number of seeds that a layer scatters: fixed, or in proportion to the area or volume, so that outlines and
/// meshes of any size get pieces of the same size.
struct SeedCount {
    CountBy by = CountBy::Number;
    double amount = 20.0;  // a whole number; 1/m² or 1/m³, > 0; m, > 0: the side of a square or cube of the mean size

    constexpr SeedCount() = default;
    constexpr SeedCount(std::uint32_t number) : amount(number) {}
    constexpr SeedCount(CountBy kind, double value) : by(kind), amount(value) {}

    /// The number of seeds for an area in m², or a volume in m³: whole, at least 1 unless given by Number; may be
    /// infinite.
    double in(double size, SeedSpace space = SeedSpace::Plane) const;
    bool operator==(const SeedCount&) const = default;
};

}  // namespace rubble
