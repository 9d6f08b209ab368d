#include "app/cli/CommonOptions.h"
#include "app/cli/ProgressLine.h"
#include "app/cli/Verb.h"
#include "core/base/Version.h"
#include "core/io/JsonLayout.h"
#include "core/io/ProjectFile.h"
#include "core/io/ReplayFile.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace rubble {
namespace {

constexpr const char* kFooter =
    R"(Plays what "simulate --record" wrote again, on the project that it was recorded of, and compares every step. Exit status 1
where it goes another way: the first step and the body that does are named.

Output:
  {"steps":N,"matches":true,"hash":"..."}
  {"steps":N,"matches":false,"step":k,"body":s,"hash":"..."}

Example:
  rubble-cli simulate house.rubble --steps 600 --shot "box at the door" --record door.replay > after.json
  rubble-cli replay door.replay house.rubble)";

struct ReplayOptions {
    std::string file;
    std::string project;
    int threads = 1;
};

std::string outcomeJson(const ReplayPlayer& player) {
    JsonLayout json;
    json.openObject();
    json.wholeNumber("steps", std::uint64_t{player.replay().steps.size()});
    json.boolean("matches", !player.divergence());
    if (player.divergence()) {
        json.wholeNumber("step", player.divergence()->step);
        json.text("body", player.divergence()->body);
    }
    json.text("hash", player.session().hash().hex());
    json.close();
    return std::move(json).finished();
}

/// What may be why a replay goes another way.
std::vector<std::string> differences(const Replay& replay, const Project& project) {
    std::vector<std::string> notices;
    if (replay.project != projectHash(project))
        notices.push_back("The project is not as it was when this was recorded.");
    if (replay.program != programVersion()) {
        notices.push_back("This was recorded by version " + replay.program + "; this is version " + programVersion() +
                          ".");
    }
    return notices;
}

Status replayAgain(const ReplayOptions& options, const CliContext& context) {
    Result<Replay> replay = loadReplay(options.file);
    if (!replay) return replay.error();
    const Result<Project> project = loadProject(options.project);
    if (!project) return project.error();
    for (const std::string& notice : differences(*replay, *project)) context.err << notice << '\n';
    ProgressLine line(context, "Replaying");
    const TaskContext task{.cancel = context.cancel,
                           .progress = [&](double fraction) { line.show(fraction); },
                           .threads = options.threads};
    Result<std::shared_ptr<const PlayScene>> scene =
        playScene(*project, {.cancel = task.cancel, .threads = task.threads});
    if (!scene) return scene.error();
    Result<ReplayPlayer> player =
        ReplayPlayer::start(std::move(*scene), std::move(*replay), {.threads = options.threads});
    if (!player) return player.error();
    const Status played = player->seek(player->replay().steps.size(), task);
    line.clear();
    if (!played) return played.error();
    if (const Status written = writeOutput("-", outcomeJson(*player), context); !written) return written.error();
    if (player->divergence()) return Error{ErrorCode::BadInput, player->divergence()->sentence()};
    return success();
}

}  // namespace

Verb addReplay(CLI::App& program) {
    CLI::App* command = program.add_subcommand("replay", "Play a recorded simulation again and compare every step");
    const auto options = std::make_shared<ReplayOptions>();
    command->footer(kFooter);
    command->add_option("REPLAY", options->file, "What simulate --record wrote")->required()->type_name("");
    command->add_option("PROJECT", options->project, "The project that it was recorded of")->required()->type_name("");
    addThreadsOption(*command, options->threads);
    return {command, [options](const CliContext& context) { return replayAgain(*options, context); }};
}

}  // namespace rubble
