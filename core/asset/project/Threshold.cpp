#include "core/asset/project/Threshold.h"

#include "core/geometry/polygon/MinimumCrossSection.h"

#include <algorithm>
#include <numbers>

namespace rubble {

double minimumCrossSection(const Prism& prism) {
    return std::min(prism.depth * minimumCrossSection(prism.outline), area(prism.outline));
}

std::optional<double> derivedThreshold(const Asset& asset, const Material& material) {
    if (!asset.contactTime || !material.tensileStrength) return std::nullopt;
    return *material.tensileStrength * minimumCrossSection(asset.prism) * *asset.contactTime;
}

std::optional<double> transitionCrackLength(const Material& material) {
    if (!material.fractureToughness || !material.tensileStrength) return std::nullopt;
    const double ratio = *material.fractureToughness / *material.tensileStrength;
    return ratio * ratio / std::numbers::pi;
}

double thresholdOf(const Asset& asset, const Material& material) {
    return derivedThreshold(asset, material).value_or(asset.threshold);
}

double thresholdOf(const Project& project, const Asset& asset) {
    return thresholdOf(asset, *findMaterial(project, asset.material));
}

bool lacksStrength(const Asset& asset, const Material& material) {
    return asset.contactTime.has_value() && !material.tensileStrength;
}

}  // namespace rubble
