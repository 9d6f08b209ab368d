#include "core/sound/synthesis/SoundMaterial.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rubble {

const SoundProperties& propertiesOf(SoundMaterial material) {
    static constexpr std::array<SoundProperties, kSoundMaterials> kProperties{{
        {2400.0, 30e9, 0.02, 0.9e-3, 0.6, "concrete"},
        {1800.0, 14e9, 0.02, 0.7e-3, 0.5, "brick"},
        {2500.0, 70e9, 0.002, 0.06e-3, 0.12, "glass"},
        {600.0, 11e9, 0.015, 0.8e-3, 0.1, "wood"},
        {1100.0, 5e9, 0.04, 1.5e-3, 0.15, "plaster"},
        {2600.0, 50e9, 0.008, 0.4e-3, 0.6, "stone"},
        {7850.0, 205e9, 0.001, 0.1e-3, 0.08, "metal"},
        {917.0, 9e9, 0.01, 0.2e-3, 0.3, "ice"},
    }};
    return kProperties[static_cast<std::size_t>(material)];
}

SoundMaterial closestSoundMaterial(double density, std::optional<double> youngsModulus) {
    const auto ratio = [](double a, double b) { return std::max(a / b, b / a); };
    SoundMaterial closest = SoundMaterial::Concrete;
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k < kSoundMaterials; ++k) {
        const auto material = static_cast<SoundMaterial>(k);
        const SoundProperties& properties = propertiesOf(material);
        // Moduli spread over two decades, densities over one: the root makes them weigh alike.
        double difference = ratio(density, properties.density);
        if (youngsModulus) difference *= std::sqrt(ratio(*youngsModulus, properties.youngsModulus));
        if (!(difference < least)) continue;
        least = difference;
        closest = material;
    }
    return closest;
}

}  // namespace rubble
