#pragma once

#include "app/cli/PlayOptions.h"
#include "app/cli/StepRecord.h"

namespace rubble {

/// How long a project is played, and what is kept of it.
struct PlayPlan {
    SimulationPlan simulation;  // of its world, threads count; the rest is as `play` says
    PlayOptions play;
    bool isRecorded = false;  // a replay is kept
};

/// Plays a project, step by step: bodies are told in the order of instances, then as they were born, without the ground. What
/// a session has to tell by the way goes to `notices`.
///
/// Errors: those of startedSession(); Cancelled.
Result<SimulationRun> played(const ProjectInPlay& project, const PlayPlan& plan, const TaskContext& task,
                             std::vector<std::string>& notices);

}  // namespace rubble
