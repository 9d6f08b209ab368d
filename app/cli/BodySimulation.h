#pragma once

#include "core/base/TaskContext.h"
#include "core/io/SimulationJson.h"
#include "core/physics/BodyScene.h"

#include <string>

namespace rubble {

/// How long, how finely and on what a scene is simulated.
struct SimulationPlan {
    int steps = 1;
    double stepLength = 1.0 / 60.0;  // s
    WorldSettings world;
    bool isTraced = false;  // a row a step is kept
    bool isTimed = false;   // the outcome and each row tell how long steps took
};

struct BodySimulation {
    SimulationOutcome outcome;
    std::string trace;  // CSV with a line of titles
};

/// Lets a scene move, step by step.
///
/// Errors: those of makeWorld(); Cancelled.
Result<BodySimulation> simulated(const BodyScene& scene, const SimulationPlan& plan, const TaskContext& task);

}  // namespace rubble
