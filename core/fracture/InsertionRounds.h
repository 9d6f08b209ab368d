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
/// Sites are inserted in rounds, each eight times as many as were there before: every 8th of them along the curve, or 64th or
/// 512th, then those between. The sites of a round find a triangulation that is nearly even: they change few triangles,
/// and ranges of them along the curve touch each other only near their borders. Of many sites each range of a round is
/// inserted on its own, and then those sites one by one whose cavity is not within one range.
///
/// Errors: Cancelled.
Status insertSites(Delaunay& delaunay, const TaskContext& task);

}  // namespace rubble
