#pragma once

#include "core/asset/Bake.h"

#include <vector>

namespace rubble {

/// The seed of the asset's own pattern that each fragment comes from: a fragment of a fragment has its ancestor's. Where
/// there are no seeds, cells of cut layers take their place (see cellId); those of an outline that nothing names have SeedId{}. O(fragments).
std::vector<SeedId> seedsOfFragments(const Bake& bake);

}  // namespace rubble
