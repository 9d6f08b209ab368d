#include "app/cli/console/InputOutput.h"
#include "app/cli/console/ProgressLine.h"
#include "app/cli/options/AnimationOptions.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/output/ProjectLoading.h"
#include "app/cli/verbs/Verb.h"
#include "core/base/Version.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/play/ReplayFile.h"

#include <memory>

namespace rubble {
namespace {

constexpr const char* kReplayFooter =
    R"(Replays the recording of "simulate --record" on its project and compares every step. Exits with 3 if the
simulation diverges, with the first step and body that differ.

Output:
  {"steps":N,"matches":true,"hash":"..."}
  {"steps":N,"matches":false,"step":k,"body":s,"difference":"broke","value":v,"hash":"..."}
The body is the one that differs most in the first step that differs: "broke" and "didNotBreak" are bodies that broke
on one side only, with the impact in N*s; "velocity" is in m/s; "unmeasured" is a recording of version 1.

Examples:
  rubble-cli simulate house.rubble --steps 600 --shot "box at the door" --record door.replay > after.json
  rubble-cli replay door.replay house.rubble
  rubble-cli replay door.replay house.rubble --animation door.usda)";

struct ReplayOptions {
    std::string file;
    std::string project;
    AnimationOptions animation;
    int threads = 1;
};

const char* wordOf(DivergenceKind kind) {
    switch (kind) {
        case DivergenceKind::Unmeasured: break;
        case DivergenceKind::Broke: return "broke";
        case DivergenceKind::DidNotBreak: return "didNotBreak";
        case DivergenceKind::Velocity: return "velocity";
        case DivergenceKind::Events: return "events";
    }
    return "unmeasured";
}

std::string outcomeJson(const ReplayPlayer& player) {
    JsonWriter json;
    json.openObject();
    json.wholeNumber("steps", std::uint64_t{player.replay().steps.size()});
    json.boolean("matches", !player.divergence());
    if (player.divergence()) {
        json.wholeNumber("step", player.divergence()->step);
        json.text("body", player.divergence()->body);
        json.text("difference", wordOf(player.divergence()->kind));
        json.number("value", player.divergence()->difference);
    }
    json.text("hash", player.session().hash().hex());
    json.close();
    return std::move(json).finished();
}

/// Returns warnings about possible causes of a divergence.
std::vector<std::string> warnings(const Replay& replay, const Project& project) {
    std::vector<std::string> messages;
    if (replay.project != projectHash(project)) messages.push_back("The project was changed after the recording.");
    if (replay.program != programVersion()) {
        messages.push_back("The recording was made by version " + replay.program + "; this is version " +
                           programVersion() + ".");
    }
    return messages;
}

/// Plays all of a replay, and writes it as an animation where one is asked for.
Status play(ReplayPlayer& player, const ReplayOptions& options, const TaskContext& task) {
    const std::uint64_t steps = player.replay().steps.size();
    std::optional<TrackRecorder> tracks = recorderFor(options.animation, player.session());
    if (!tracks) return player.seek(steps, task);
    for (std::uint64_t step = 1; step <= steps; ++step) {
        if (const Status played = player.seek(step, {.cancel = task.cancel}); !played) return played;
        if (const Status fits = tracks->add(player.session()); !fits) return fits;
        task.report(static_cast<double>(step) / static_cast<double>(steps));
    }
    return saveAnimation(options.animation.file, player.session().scene().project, std::move(*tracks).tracks(), task);
}

Status verifyReplay(const ReplayOptions& options, VerbReport& report, const CliContext& context) {
    if (const Status valid = checkAnimation(options.animation); !valid) return valid;
    Result<Replay> replay = loadReplay(options.file);
    if (!replay) return replay.error();
    const Result<Project> project = openProject(options.project, context);
    if (!project) return project.error();
    for (const std::string& warning : warnings(*replay, *project)) context.err << warning << '\n';
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
    const Status played = play(*player, options, task);
    line.clear();
    if (!played) return played.error();
    if (player->divergence()) conclude(report, player->divergence()->diagnostic().message);
    return printText(outcomeJson(*player), context);
}

}  // namespace

Verb addReplay(CLI::App& program) {
    Command command(program, "replay", "Replay a recorded simulation and compare every step", kReplayFooter);
    const auto options = std::make_shared<ReplayOptions>();
    command.argument("REPLAY", options->file, "The recording, written by simulate --record").required().reads();
    command.argument("PROJECT", options->project, "The project that was recorded").required().reads();
    addAnimationOptions(command, options->animation);
    addThreadsOption(command, options->threads);
    return {command, [options](VerbReport& report, const CliContext& context) {
                return verifyReplay(*options, report, context);
            }};
}

}  // namespace rubble
