#pragma once

#include "core/asset/bake/Bake.h"

#include <optional>
#include <vector>

namespace rubble {

/// The seed of the asset's pattern that each fragment comes from; a fragment of a deeper level has its ancestor's.
/// Patterns without seeds name the cell of their cut layers instead (see cellId()), or SeedId{} for an outline that was
/// not cut. O(fragments).
std::vector<SeedId> seedsOfFragments(const Bake& bake);

/// The same for the pattern that fractures `parent` (empty: the whole asset); none for `parent` and everything outside
/// it.
std::vector<std::optional<SeedId>> seedsOfFragments(const Bake& bake, const FragmentPath& parent);

}  // namespace rubble
