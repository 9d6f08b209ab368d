#pragma once

#include "core/fracture/Partition.h"

#include <optional>
#include <string>

namespace rubble::oracle {

/// Whether a partition is one planar subdivision of the outline, by counting alone: corners lie apart; each
/// directed edge occurs once and its reverse belongs to the piece named behind it; the edges with nothing behind
/// them are closed curves through every point of the outline, bit for bit. A T-junction leaves an edge without
/// reverse. Says what is wrong first, or nothing.
std::optional<std::string> subdivisionFault(const Partition& partition, const Polygon& outline);

}  // namespace rubble::oracle
