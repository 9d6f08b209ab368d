#pragma once

#include "core/io/json/FormatVersion.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/pack/PackFile.h"

#include <array>
#include <string_view>

namespace rubble {

/// The format and version in pack.json.
inline constexpr FileFormat kPackFormat{.name = "rubble-pack", .noun = "pack", .version = kPackVersion};

/// In place of the checksum, where the checksum is computed.
inline constexpr std::string_view kNoChecksum = "00000000000000000000000000000000";

/// The names of enumerators in pack.json, in their order.
inline constexpr std::array<std::string_view, 3> kMeshBodies{"whole", "fragments", "fragment"};
inline constexpr std::array<std::string_view, 2> kMeshPlaces{"assembled", "centred"};
inline constexpr std::array<std::string_view, 3> kPackFalloffs{"constant", "linear", "smooth"};
inline constexpr std::array<std::string_view, 2> kPackBreaks{"whole", "bonded"};
inline constexpr std::array<std::string_view, 2> kPackRules{"impact", "momentum"};
inline constexpr std::array<std::string_view, 2> kPackSides{"outside", "inside"};

/// Writes the units, as the member "units", of a pack or a scene.
void writeUnits(JsonWriter& json);

/// What all packs of this version say.
inline constexpr std::string_view kPackVelocity = "beforeSolver";
inline constexpr std::string_view kPackFrictionOfPair = "geometricMean";
inline constexpr std::string_view kPackRestitutionOfPair = "maximum";

}  // namespace rubble
