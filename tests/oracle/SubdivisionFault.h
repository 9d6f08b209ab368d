#pragma once

#include "core/fracture/partition/Partition.h"

#include <optional>
#include <string>

namespace rubble::oracle {

/// Verifies combinatorially that a partition is one planar subdivision of the outline: corners are distinct; each
/// directed edge occurs once, and its reverse belongs to the neighbour; the edges without neighbour are closed curves
/// through every point of the outline, bit for bit. A T-junction leaves an edge without reverse. Returns the first
/// fault, or nothing.
std::optional<std::string> subdivisionFault(const Partition& partition, const Polygon& outline);

}  // namespace rubble::oracle
