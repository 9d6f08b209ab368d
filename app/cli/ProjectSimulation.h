#pragma once

#include "app/cli/StepRecord.h"
#include "core/base/TaskContext.h"
#include "core/play/Session.h"

namespace rubble {

/// A project's scene, the shots it is given, and whether anything breaks.
struct PlayPlan {
    SimulationPlan simulation;
    std::vector<Shot> shots;
    bool hasDestruction = true;
    bool isRecorded = false;  // a replay is kept
};

/// Plays a project, step by step: bodies are told in the order of instances, then as they were born, without the ground. What
/// a session has to tell by the way goes to `notices`.
///
/// Errors: those of Session::start() and Session::add(), the latter with the shot's name; Cancelled.
Result<SimulationRun> played(std::shared_ptr<const PlayScene> scene, const PlayPlan& plan, const TaskContext& task,
                             std::vector<std::string>& notices);

}  // namespace rubble
