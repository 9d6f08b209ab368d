#pragma once

#include "core/fracture/partition/Partition.h"
#include "core/geometry/polygon/Polygon.h"

#include <optional>
#include <string>

namespace rubble {

/// Returns the first fault of a partition in one sentence, or nothing: every edge has its reverse in the neighbour or
/// lies on the outline, whose points are all kept; no ring touches itself, no points disconnect a piece; rings have
/// area and the right winding; areas sum to the outline's minus the gap (relative 1e-9).
std::optional<std::string> verifyPartition(const Partition& partition, const Polygon& outline);

}  // namespace rubble
