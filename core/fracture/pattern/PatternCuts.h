#pragma once

#include "core/fracture/cuts/CutSet.h"
#include "core/fracture/pattern/Pattern.h"

namespace rubble {

/// Whether a pattern has an enabled layer that cuts.
bool hasCuts(const Pattern& pattern);

/// The cuts of a pattern on a validated() outline. The same pattern and outline give the same bits.
///
/// Errors: BadInput if verifyPattern() finds a fault; Limit above kMaxCuts; Cancelled.
Result<CutSet> cutsOf(const Pattern& pattern, const Polygon& outline, const TaskContext& task = {});

/// The width of the joints between pieces, in m: the widest mortar of the pattern's layers, 0 without mortar. Cuts run
/// along the centre lines of the joints.
double jointWidthOf(const Pattern& pattern);

}  // namespace rubble
