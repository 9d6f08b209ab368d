#pragma once

#include "core/asset/bake/Bake.h"

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace rubble {

/// The part of the squared diagonal of what was cut that fragments of a mesh must have in common to be neighbours
/// across their parents: far above the rounding of faces that meet at an edge only.
inline constexpr double kMinCommonArea = 1e-9;

/// What neighboursAcrossParents() gives, for the bake of a mesh and some of its fragments, none of which descends from
/// another.
std::vector<std::pair<std::uint32_t, std::uint32_t>> solidNeighbours(const Bake& bake,
                                                                     std::span<const std::uint32_t> fragments);

}  // namespace rubble
