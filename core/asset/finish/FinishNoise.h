#pragma once

#include "core/geometry/predicates/Vec.h"

#include <array>
#include <cstdint>
#include <vector>

namespace rubble {

/// Noise in a cube that repeats in all directions, from which all finishes are made. It is the same on every machine.
///
/// Four bytes for each of kSide³ texels, x first: gradient noise of three octaves (0), the same with other random
/// numbers (1), the distance to the nearest of the points of a jittered grid, in cells (2), and a random number of that
/// point (3). Sources: Perlin, "Improving noise", 2002; Worley, "A cellular texture basis function", 1996.
class FinishNoise {
public:
    static constexpr int kSide = 64;  // texels
    static constexpr int kCells = 8;  // of the cellular noise, on each side; gradient noise begins with half as many

    /// Computed at the first call, in some 100 ms.
    static const FinishNoise& shared();

    const std::vector<std::uint8_t>& texels() const { return m_texels; }
    /// Each channel in [0, 1] at a place; the cube measures 1. Interpolated linearly, as textures are: texel k is at
    /// (k + 1/2) / kSide.
    std::array<double, 4> at(Vec3 place) const;

private:
    FinishNoise();
    std::vector<std::uint8_t> m_texels;
};

}  // namespace rubble
