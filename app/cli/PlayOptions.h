#pragma once

#include "app/cli/ChosenShots.h"
#include "core/base/TaskContext.h"
#include "viewport/scene/Take.h"

namespace rubble {

/// How a project is played, as it is told on the command line.
struct PlayOptions {
    double stepLength = 1.0 / 60.0;  // s
    ShotOptions shots;
    bool isUnbreakable = false;
    bool isSleepless = false;  // bodies at rest are moved on; no option of these, but simulate's own
};

/// A project made ready, with the shots that are fired at it.
struct ProjectInPlay {
    std::shared_ptr<const PlayScene> scene;
    std::vector<Shot> shots;
};

inline constexpr int kMostSteps = 10'000'000;  // beyond this nobody waits for the end

/// Adds --dt, --shot, --shots and --no-destruction.
void addPlayOptions(CLI::App& command, PlayOptions& options);

/// Bakes all of a project. Sentences about it go to `context.err`.
///
/// Errors: those of chosenShots() and of playScene().
Result<ProjectInPlay> projectInPlay(const Project& project, const PlayOptions& options, const CliContext& context,
                                    const TaskContext& task);

/// A session that has not begun, with all shots waiting.
///
/// Errors: those of Session::start() and Session::add().
Result<Session> startedSession(const ProjectInPlay& play, const PlayOptions& options, int threads);

/// Hands what a take has to tell on to `context.err`.
void tellNotices(Take& take, const CliContext& context);

/// Takes a session to a step. Sentences that it has to tell go to `context.err`.
///
/// Errors: Cancelled.
Status playTo(Session& session, std::uint64_t step, const CliContext& context, const TaskContext& task);

}  // namespace rubble
