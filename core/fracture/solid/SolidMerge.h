#pragma once

#include "core/fracture/solid/SolidPartition.h"

#include <cstdint>
#include <span>
#include <vector>

namespace rubble {

/// Merges fragments into others. `receivers`: for each fragment, the one that it is merged into, or itself; a receiver
/// is not merged itself. Faces between merged fragments are gone; all others stay as they are. The receiver keeps its
/// seed and its part number.
SolidPartition mergedFragments(SolidPartition partition, std::span<const std::uint32_t> receivers);

/// Merges fragments below a volume, m³, the smallest first (ties go to the first), into the neighbour with the largest
/// common face, until none is too small or has a neighbour. `merged` gets the fragments that are gone, as numbered
/// before.
SolidPartition withoutSmallFragments(SolidPartition partition, double minVolume,
                                     std::vector<std::uint32_t>* merged = nullptr);

}  // namespace rubble
