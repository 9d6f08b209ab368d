#pragma once

#include "app/cli/options/AnimationOptions.h"
#include "app/cli/options/PlayOptions.h"
#include "app/cli/simulation/StepRecord.h"
#include "core/io/play/EventsFile.h"
#include "core/play/session/SavedSession.h"

namespace rubble {

/// The options of a project's simulation.
struct PlayPlan {
    SimulationPlan simulation;  // of `world` only the threads are used; `play` has the rest
    PlayOptions play;
    bool isRecorded = false;             // as a replay
    std::optional<EventsFormat> events;  // they are kept
    bool isHeard = false;                // its sound is made
    AnimationOptions animation;          // its tracks are recorded
    std::string state;                   // file to start from; empty: from the start
    std::string remapped;                // the project that the state was of: only its damage is taken; empty: none
    std::string savedState;              // file for the state after the last step; empty: none
    StateKind savedKind = StateKind::Whole;
};

/// Simulates a project. The resulting bodies are the instances, then projectiles and fragments in order of creation,
/// without the ground. What the session reports is appended to `diagnostics`.
///
/// Errors: those of createSession(), loadState(), remappedSession() and saveState(); Cancelled.
Result<SimulationRun> runProject(const PreparedProject& project, const PlayPlan& plan, const TaskContext& task,
                                 std::vector<Diagnostic>& diagnostics);

}  // namespace rubble
