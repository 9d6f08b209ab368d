#pragma once

#include "core/asset/project/Project.h"

#include <compare>
#include <cstdint>
#include <string>
#include <vector>

namespace rubble {

/// The key of a bake: an asset and the number of its variant.
struct AssetVariant {
    Id asset = 0;
    std::uint32_t variant = 0;  // 0: the asset itself
    auto operator<=>(const AssetVariant&) const = default;
};

/// The asset with the random seed of every layer of every level mixed with the variant's number: the same shape,
/// fractured differently. Overrides of scattered seeds and fragment edits are dropped, since they refer to the old
/// seeds; placed seeds stay. Has the nameOfVariant(); variant 0 is the asset itself.
Asset variantOf(Asset asset, std::uint32_t variant);

/// The name of a variant of an asset: "wall~2"; of variant 0 the asset's.
std::string nameOfVariant(const std::string& asset, std::uint32_t variant);

AssetVariant variantOf(const Instance& instance);

/// Every asset itself, and the variants that instances use. Ascending.
std::vector<AssetVariant> usedVariants(const Project& project);

}  // namespace rubble
