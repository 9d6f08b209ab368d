#pragma once

#include <cstdint>

namespace rubble {

/// The damage of a bond: n/255 of what it held is gone.
using BondDamage = std::uint8_t;
inline constexpr BondDamage kIntact = 0;
inline constexpr BondDamage kBroken = 255;

}  // namespace rubble
