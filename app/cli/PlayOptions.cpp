#include "app/cli/PlayOptions.h"

#include "app/cli/CommonOptions.h"

#include <CLI/CLI.hpp>

#include <ostream>

namespace rubble {

void addPlayOptions(CLI::App& command, PlayOptions& options) {
    command.add_option("--dt", options.stepLength, "The length of a step in seconds: 1/60 if not given")
        ->check(numberBetween(kShortestStep, kLongestStep))
        ->option_text("S");
    addShotOptions(command, options.shots);
    command.add_flag("--no-destruction", options.isUnbreakable, "Let nothing break, to compare");
}

Result<ProjectInPlay> projectInPlay(const Project& project, const PlayOptions& options, const CliContext& context,
                                    const TaskContext& task) {
    Result<std::vector<Shot>> shots = chosenShots(project, options.shots, context);
    if (!shots) return shots.error();
    Result<std::shared_ptr<const PlayScene>> scene = playScene(project, task);
    if (!scene) return scene.error();
    for (const std::string& notice : (*scene)->notices) context.err << notice << '\n';
    return ProjectInPlay{std::move(*scene), std::move(*shots)};
}

Result<Session> startedSession(const ProjectInPlay& play, const PlayOptions& options, int threads) {
    Result<Session> session = Session::start(play.scene, {.dt = options.stepLength,
                                                          .sleeping = !options.isSleepless,
                                                          .hasDestruction = !options.isUnbreakable,
                                                          .threads = threads});
    if (!session) return session.error();
    for (const Shot& shot : play.shots) {
        if (const Status added = session->add(shot); !added) return added.error();
    }
    return session;
}

void tellNotices(Take& take, const CliContext& context) {
    for (const std::string& notice : take.takeNotices()) context.err << notice << '\n';
}

Status playTo(Session& session, std::uint64_t step, const CliContext& context, const TaskContext& task) {
    const std::uint64_t first = session.stepsDone();
    while (session.stepsDone() < step) {
        if (task.isCancelled()) return TaskContext::cancelled();
        session.step();
        for (const std::string& notice : session.events().notices) context.err << notice << '\n';
        task.report(static_cast<double>(session.stepsDone() - first) / static_cast<double>(step - first));
    }
    return success();
}

}  // namespace rubble
