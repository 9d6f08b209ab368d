#include "core/asset/strength/BondStrength.h"

#include "core/asset/strength/Threshold.h"

namespace rubble {

std::optional<double> derivedBondImpulse(const Asset& asset, const Material& material) {
    if (!material.tensileStrength) return std::nullopt;
    return *material.tensileStrength * asset.contactTime.value_or(kDefaultContactTime);
}

std::optional<double> bondImpulseOf(const Asset& asset, const Material& material) {
    return asset.bonding.impulsePerArea ? asset.bonding.impulsePerArea : derivedBondImpulse(asset, material);
}

}  // namespace rubble
