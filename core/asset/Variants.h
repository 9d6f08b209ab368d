#pragma once

#include "core/asset/Project.h"

#include <compare>
#include <cstdint>
#include <vector>

namespace rubble {

/// An asset in one of the ways it breaks: what bakes are kept by.
struct AssetVariant {
    Id asset = 0;
    std::uint32_t variant = 0;  // 0: as the asset says
    auto operator<=>(const AssetVariant&) const = default;
};

/// The asset with the random seed of every layer, of all levels, mixed with the variant's number: the same shape, broken in
/// another way. Overrides of scattered seeds are left out, for they were made by eye for seeds that are elsewhere now; seeds
/// placed by hand stay. It is called "wall~2"; variant 0 is the asset as it is.
Asset variantOf(Asset asset, std::uint32_t variant);

AssetVariant variantOf(const Instance& instance);

/// All that a project's scene is made of: every asset as it is, and the variants that instances of them ask for.
/// Ascending.
std::vector<AssetVariant> usedVariants(const Project& project);

}  // namespace rubble
