#pragma once

#include <array>
#include <string_view>

namespace rubble {

/// What surfaces of a material look like beyond their colours: a pattern that is computed, without images.
enum class Finish { Plain, Brick, Concrete, Glass, Ice, Metal, Plaster, Stone, Tiles, Wood };

/// Their names in files, in the order of Finish.
inline constexpr std::array<std::string_view, 10> kFinishNames{"plain", "brick",   "concrete", "glass", "ice",
                                                               "metal", "plaster", "stone",    "tiles", "wood"};

}  // namespace rubble
