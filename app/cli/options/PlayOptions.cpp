#include "app/cli/options/PlayOptions.h"

#include "app/cli/options/Command.h"
#include "core/asset/project/Ranges.h"

#include <algorithm>
#include <ostream>

namespace rubble {

void addPlayOptions(Command& command, PlayOptions& options) {
    command.option("--dt", options.stepLength, "The time step in seconds (default: 1/60)")
        .inRange(ProjectNumber::StepLength)
        .valueName("S");
    addShotOptions(command, options.shots);
    command.flag("--no-destruction", options.isWithoutDestruction, "Disable destruction");
}

Result<PreparedProject> prepareProject(const Project& project, const PlayOptions& options, const CliContext& context,
                                       const TaskContext& task) {
    Result<std::vector<Shot>> shots = selectedShots(project, options.shots, context);
    if (!shots) return shots.error();
    Result<std::shared_ptr<const PlayScene>> scene = playScene(project, task);
    if (!scene) return scene.error();
    printMessages((*scene)->diagnostics, context);
    return PreparedProject{std::move(*scene), std::move(*shots)};
}

Result<Session> createSession(const PreparedProject& play, const PlayOptions& options, int threads) {
    Result<Session> session = Session::start(play.scene, {.dt = options.stepLength,
                                                          .sleeping = !options.isSleepless,
                                                          .hasDestruction = !options.isWithoutDestruction,
                                                          .threads = threads});
    if (!session) return session.error();
    for (const Shot& shot : play.shots) {
        if (const Status added = session->add(shot); !added) return added.error();
    }
    return session;
}

void printMessages(const std::vector<Diagnostic>& diagnostics, const CliContext& context) {
    constexpr std::size_t kMaxPrinted = 20;
    const std::size_t printed = std::min(diagnostics.size(), kMaxPrinted);
    for (std::size_t k = 0; k < printed; ++k) context.err << diagnostics[k].message << '\n';
    if (printed < diagnostics.size()) {
        context.err << diagnostics.size() - printed << " more messages are not shown.\n";
    }
}

void printWarnings(SessionPlayback& playback, const CliContext& context) {
    printMessages(playback.drainDiagnostics(), context);
}

Status simulateTo(Session& session, std::uint64_t step, const CliContext& context, const TaskContext& task) {
    const std::uint64_t first = session.stepsDone();
    while (session.stepsDone() < step) {
        if (task.isCancelled()) return TaskContext::cancelled();
        session.step();
        printMessages(session.events().diagnostics, context);
        task.report(static_cast<double>(session.stepsDone() - first) / static_cast<double>(step - first));
    }
    return success();
}

}  // namespace rubble
