#pragma once

#include "app/cli/StepRecord.h"
#include "core/base/TaskContext.h"
#include "core/physics/BodyScene.h"

namespace rubble {

/// Lets a scene move, step by step.
///
/// Errors: those of makeWorld(); Cancelled.
Result<SimulationRun> simulated(const BodyScene& scene, const SimulationPlan& plan, const TaskContext& task);

}  // namespace rubble
