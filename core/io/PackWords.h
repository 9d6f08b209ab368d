#pragma once

#include <array>
#include <string_view>

namespace rubble {

// The words of pack.json, in the order of their enumerators.
inline constexpr std::array<std::string_view, 1> kPackFormat{"rubble-pack"};
inline constexpr std::array<std::string_view, 3> kMeshBodies{"whole", "fragments", "fragment"};
inline constexpr std::array<std::string_view, 2> kMeshPlaces{"assembled", "centred"};

}  // namespace rubble
