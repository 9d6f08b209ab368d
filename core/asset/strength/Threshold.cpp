#include "core/asset/strength/Threshold.h"

#include "core/geometry/polygon/MinimumCrossSection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rubble {
namespace {

/// The inverse angular frequency of the lowest vibration of the plate that kBendingRatio belongs to, over the time of
/// sound through its thickness: a²/t² sqrt(12 (1 - nu²)) / 4.86.
/// Source: Leissa, Vibration of Plates, NASA SP-160, 1969, section 2.1: 4.860 for nu = 1/4, simply supported.
const double kResponse = kBendingRadius * kBendingRadius * std::sqrt(12.0 * (1.0 - 1.0 / 16.0)) / 4.86;

}  // namespace

double thicknessOf(const Prism& prism) { return std::min(prism.depth, minimumCrossSection(prism.outline)); }

double thicknessOf(const Asset& asset) {
    if (asset.isPrism()) return thicknessOf(asset.prism());
    const ClosedMesh& mesh = *asset.mesh();
    const Vec3 size = mesh.bounds.max - mesh.bounds.min;
    return std::min({size.x, size.y, size.z});
}

std::optional<BendingStrength> bendingStrength(const Asset& asset, const Material& material) {
    if (!asset.contactTime || !material.tensileStrength) return std::nullopt;
    BendingStrength strength{.thickness = thicknessOf(asset)};
    strength.force = *material.tensileStrength * strength.thickness * strength.thickness / kBendingRatio;
    strength.duration = 2.0 / std::numbers::pi * *asset.contactTime;  // of half a sine wave with that peak
    if (!material.youngsModulus) return strength;
    const double response = kResponse * strength.thickness * std::sqrt(material.density / *material.youngsModulus);
    strength.isByInertia = response > strength.duration;
    strength.duration = std::max(strength.duration, response);
    return strength;
}

std::optional<double> derivedThreshold(const Asset& asset, const Material& material) {
    const std::optional<BendingStrength> strength = bendingStrength(asset, material);
    return strength ? std::optional(strength->threshold()) : std::nullopt;
}

void deriveThreshold(Asset& asset) { asset.contactTime = kDefaultContactTime; }

void deriveThresholdIfKnown(Asset& asset, const Material& material) {
    if (material.tensileStrength) deriveThreshold(asset);
}

bool hasDefaultThreshold(const Asset& asset) { return asset.contactTime || asset.threshold == Asset{}.threshold; }

void enterThreshold(Asset& asset, double threshold) {
    asset.threshold = threshold;
    asset.contactTime.reset();
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
