#pragma once

#include "core/fracture/partition/Partition.h"
#include "core/fracture/pieces/SmallPieces.h"

#include <optional>
#include <string>

namespace rubble {

/// Returns the first piece below the size limit, or nothing. A single piece may have any size; 1e-9 of the limit is
/// tolerated.
std::optional<std::string> verifyNoSmallPieces(const Partition& partition, const SmallPieces& small, double depth);

}  // namespace rubble
