#pragma once

#include "core/fracture/fragments/Fragment.h"
#include "core/fracture/layer/SeedId.h"

#include <span>
#include <string>

namespace rubble {

/// The id by which a fragment is selected: of a piece, see cellId(Partition); of a fragment of a mesh, that of its
/// seed, or 0.0 without seeds.
SeedId cellId(const Fragment& fragment, std::span<const SeedId> seeds);

/// The name of a fragment in an asset or a fragment: of a piece, see pieceName(); of a fragment of a mesh, the id of
/// its seed, and a number if its cell falls into several: "5.17.1".
std::string fragmentName(const Fragment& fragment, std::span<const SeedId> seeds);

}  // namespace rubble
