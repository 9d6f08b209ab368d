#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/delaunay/Delaunay.h"

namespace rubble {

/// The minimum number of sites for several threads; fewer are triangulated by one.
inline constexpr std::size_t kMinSitesForThreads = 32768;

/// Triangulates at least three sites, the first three of which are not collinear. Fills `delaunay.triangles`; the
/// insertion order depends only on the number of sites.
///
/// Sites are inserted in rounds, each with eight times as many as there are already: first every 8th along the curve
/// (or 64th, or 512th), then those between them. Each round thus starts from a nearly uniform triangulation: its sites
/// change few triangles each, and ranges of them along the curve interact only near their borders. With many sites the
/// ranges of a round are inserted in parallel, and then, one by one, the sites whose cavity is not within one range.
///
/// Errors: Cancelled.
Status insertSites(Delaunay& delaunay, const TaskContext& task);

}  // namespace rubble
