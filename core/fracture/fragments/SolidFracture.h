#pragma once

#include "core/base/Result.h"
#include "core/base/TaskContext.h"
#include "core/fracture/fragments/Fragment.h"
#include "core/fracture/solid/SolidHulls.h"

namespace rubble {

/// The fragments of a partition of a closed mesh, with mass properties, contacts and the hulls that they collide as.
/// In parallel.
///
/// Errors: those of fragmentHulls(); Cancelled.
Result<Fragments> solidFragments(SolidPartition partition, const HullLimits& limits = {}, const TaskContext& task = {});

}  // namespace rubble
