#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/fragments/Fragment.h"
#include "core/fracture/solid/SolidHulls.h"

namespace rubble {

/// The fragments of a partition of a closed mesh, with mass properties, contacts and the hulls that they collide as.
/// In parallel.
///
/// With a `gap` (m, > 0) fragments are what shrunkFragments() leaves of them; contacts do not change. Fragments that
/// vanish or are too thin for a hull are reported (VanishedPiece) and omitted with their mass, and the volume that the
/// gap takes is reported (Gap).
///
/// Errors: those of fragmentHulls() and shrunkFragments(); Cancelled.
Result<Fragments> solidFragments(SolidPartition partition, double gap = 0.0, const HullLimits& limits = {},
                                 const TaskContext& task = {});

}  // namespace rubble
