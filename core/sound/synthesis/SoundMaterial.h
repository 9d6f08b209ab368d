#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace rubble {

/// Materials that sound differently.
enum class SoundMaterial : std::uint8_t { Concrete, Brick, Glass, Wood, Plaster, Stone, Metal, Ice };
inline constexpr int kSoundMaterials = 8;

/// What a material's sound follows from.
struct SoundProperties {
    double density = 2400.0;      // kg/m³
    double youngsModulus = 30e9;  // Pa
    double lossFactor = 0.02;     // of vibrations: the share of their energy lost in a radian
    double contactTime = 0.4e-3;  // s, of a blow by 1 kg
    double slenderness = 0.5;     // thickness over length of usual fragments
    std::string_view name;        // as in "glass"
};

/// The properties of a material: densities and moduli as in the library of materials.
/// Source of the loss factors: Cremer, Heckl, Petersson, "Structure-Borne Sound", 3rd edition, table 4.3, rounded.
const SoundProperties& propertiesOf(SoundMaterial material);

/// The material that is closest to a density, kg/m³, and a Young's modulus, Pa, by their ratios; by the density alone
/// where the modulus is unknown. Both must be positive.
SoundMaterial closestSoundMaterial(double density, std::optional<double> youngsModulus);

}  // namespace rubble
