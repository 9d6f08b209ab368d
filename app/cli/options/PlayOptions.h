#pragma once

#include "app/cli/options/ShotOptions.h"
#include "core/base/TaskContext.h"
#include "viewport/scene/play/SessionPlayback.h"

namespace rubble {

class Command;

/// The options of a simulation on the command line.
struct PlayOptions {
    double stepLength = 1.0 / 60.0;  // s
    ShotOptions shots;
    bool isWithoutDestruction = false;
    bool isSleepless = false;  // bodies at rest do not sleep; set by --no-sleep of simulate
};

/// The scene of a project and the shots to fire at it.
struct PreparedProject {
    std::shared_ptr<const PlayScene> scene;
    std::vector<Shot> shots;
};

/// Adds --dt, --shot, --shots and --no-destruction.
void addPlayOptions(Command& command, PlayOptions& options);

/// Bakes a project for a simulation; the diagnostics of its scene go to `context.err`.
///
/// Errors: those of selectedShots() and of playScene().
Result<PreparedProject> prepareProject(const Project& project, const PlayOptions& options, const CliContext& context,
                                       const TaskContext& task);

/// Creates a session with its shots, before the first step.
///
/// Errors: those of Session::start() and Session::add().
Result<Session> createSession(const PreparedProject& play, const PlayOptions& options, int threads);

/// Prints messages to `context.err`, a line each: the first 20, then how many are not shown.
void printMessages(const std::vector<Diagnostic>& diagnostics, const CliContext& context);

/// Prints the diagnostics of a playback that were not printed yet, as printMessages() does.
void printWarnings(SessionPlayback& playback, const CliContext& context);

/// Simulates a session up to a step; the diagnostics of each step go to `context.err`.
///
/// Errors: Cancelled.
Status simulateTo(Session& session, std::uint64_t step, const CliContext& context, const TaskContext& task);

}  // namespace rubble
