#pragma once

#include "core/io/FormatVersion.h"
#include "core/io/PackFile.h"

#include <array>
#include <string_view>

namespace rubble {

/// How a pack names itself, and its version.
inline constexpr FileFormat kPackFormat{.name = "rubble-pack", .noun = "pack", .version = kPackVersion};

/// The words of pack.json, in the order of their enumerators.
inline constexpr std::array<std::string_view, 3> kMeshBodies{"whole", "fragments", "fragment"};
inline constexpr std::array<std::string_view, 2> kMeshPlaces{"assembled", "centred"};

}  // namespace rubble
