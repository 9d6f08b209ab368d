#pragma once

#include "app/cli/simulation/StepRecord.h"
#include "core/base/Diagnostic.h"
#include "core/base/TaskContext.h"
#include "core/physics/world/BodyScene.h"

namespace rubble {

/// Simulates a scene of bodies. Those that leave the world are removed, with a diagnostic each.
///
/// Errors: those of makeWorld(); Cancelled.
Result<SimulationRun> runBodies(const BodyScene& scene, const SimulationPlan& plan, const TaskContext& task,
                                std::vector<Diagnostic>& diagnostics);

}  // namespace rubble
