#pragma once

#include "core/asset/Bake.h"

#include <vector>

namespace rubble {

/// The seed of the asset's own pattern that each fragment comes from: a fragment of a fragment has its ancestor's. Those
/// of an outline that no seed broke have SeedId{}. O(fragments).
std::vector<SeedId> seedsOfFragments(const Bake& bake);

}  // namespace rubble
