#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/Delaunay.h"

namespace rubble {

/// Sites below which several threads are not worth their while.
inline constexpr std::size_t kLeastForThreads = 32768;

/// Triangulates at least three sites of which the first three do not lie on one line. Fills `delaunay.triangles`; the order
/// of the insertions depends on nothing but the number of sites.
///
/// Few are inserted along the curve. Many are inserted in rounds, every 64th, then every 8th, then all: the sites of a
/// round find a triangulation that is nearly even, so that ranges of them along the curve touch each other only near
/// their borders. The first round goes in one by one; in the others each range is inserted on its own, and then those
/// sites one by one whose cavity is not within one range.
///
/// Errors: Cancelled.
Status insertSites(Delaunay& delaunay, const TaskContext& task);

}  // namespace rubble
