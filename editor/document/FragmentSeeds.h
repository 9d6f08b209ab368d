#pragma once

#include "core/asset/Bake.h"

#include <optional>
#include <vector>

namespace rubble {

/// The seed of the asset's own pattern that each fragment comes from: a fragment of a fragment has its ancestor's. Where
/// there are no seeds, cells of cut layers take their place (see cellId); those of an outline that nothing names have SeedId{}. O(fragments).
std::vector<SeedId> seedsOfFragments(const Bake& bake);

/// The same by the pattern that breaks the fragment `inside` (empty: the whole); none for fragments that do not lie in there, itself
/// included.
std::vector<std::optional<SeedId>> seedsOfFragments(const Bake& bake, const FragmentPath& inside);

}  // namespace rubble
