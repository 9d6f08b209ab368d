#include "core/asset/strength/BondStrength.h"

#include "core/asset/project/Ranges.h"
#include "core/asset/strength/Threshold.h"

namespace rubble {

std::optional<double> derivedBondImpulse(const Asset& asset, const Material& material) {
    if (!material.tensileStrength) return std::nullopt;
    return *material.tensileStrength * asset.contactTime.value_or(kDefaultContactTime);
}

double bondImpulseOf(const Asset& asset, const Material& material) {
    if (asset.bonding.impulsePerArea) return *asset.bonding.impulsePerArea;
    return derivedBondImpulse(asset, material).value_or(rangeOf(ProjectNumber::BondImpulse).defaultValue);
}

}  // namespace rubble
