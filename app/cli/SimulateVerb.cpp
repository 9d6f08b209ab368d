#include "app/cli/BodySimulation.h"
#include "app/cli/CommonOptions.h"
#include "app/cli/ProgressLine.h"
#include "app/cli/ProjectSimulation.h"
#include "app/cli/Verb.h"
#include "core/io/BodiesJson.h"
#include "core/io/ProjectFile.h"
#include "core/io/ReplayFile.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace rubble {
namespace {

constexpr const char* kFooter = R"(Input, from FILE or standard input: a project, or plain bodies as
  {"gravity":[x,y,z],"bodies":[{"name":s,"kind":"dynamic","density":d,"friction":f,"restitution":r,
   "position":[x,y,z],"orientation":[w,x,y,z],"velocity":[x,y,z],"angularVelocity":[x,y,z],
   "hulls":[[[x,y,z],...],...]},...]}
"kind" is dynamic, static or kinematic; position and orientation place the frame of the hulls in the world; velocities
are in world axes, the linear one that of the centre of mass. All but "name" and "hulls" may be left out. Metres,
kilograms, seconds, radians; y points up. A project's instances stand on its ground, and its shots are fired where
--shot or --shots asks for them.

Output:
  {"steps":N,"bodies":[{"name":s,"position":[x,y,z],"orientation":[w,x,y,z],"asleep":false},...],
   "counts":{"bodies":n,"pairs":n,"contactPoints":n},"swaps":n,"breaks":[...],"largestPenetration":d,"hash":"..."}
Counts are means over the last 120 steps; the penetration is exact, on the final poses. A break is
  {"step":k,"body":s,"impact":J,"threshold":J,"point":[x,y,z],"fragments":n}, with --timings "swapMilliseconds", too.
Of a project the bodies are its instances, then what was thrown and broken off, as it came to be. The same input gives
the same bits on any number of threads: compare hashes.

Examples:
  rubble-cli simulate house.json --steps 600 > after.json
  rubble-cli simulate house.json --steps 600 --trace steps.csv --timings
  rubble-cli simulate house.rubble --steps 600 --shot "box at the door")";

struct SimulateOptions {
    std::string input = "-";
    std::string trace;
    int steps = 0;
    int threads = 1;
    bool isTimed = false;
    std::string record;
    PlayOptions play;
};

SimulationPlan planOf(const SimulateOptions& options) {
    return {.steps = options.steps,
            .stepLength = options.play.stepLength,
            .world = {.sleeping = !options.play.isSleepless, .threads = options.threads},
            .isTraced = !options.trace.empty(),
            .isTimed = options.isTimed};
}

/// Runs `work` with a line on the terminal that tells how far it is.
template <class Work>
Result<SimulationRun> onTerminal(const SimulateOptions& options, const CliContext& context, const Work& work) {
    ProgressLine line(context, "Simulating");
    Result<SimulationRun> result = work(TaskContext{.cancel = context.cancel,
                                                    .progress = [&](double fraction) { line.show(fraction); },
                                                    .threads = options.threads});
    line.clear();
    return result;
}

Result<SimulationRun> bodiesSimulated(const BodyScene& scene, const SimulateOptions& options,
                                      const CliContext& context) {
    const ShotOptions& shots = options.play.shots;
    if (!shots.names.empty() || !shots.file.empty() || options.play.isUnbreakable || !options.record.empty()) {
        return Error{ErrorCode::BadInput,
                     "Plain bodies have no shots, never break and are not recorded; give a project."};
    }
    return onTerminal(options, context,
                      [&](const TaskContext& task) { return simulated(scene, planOf(options), task); });
}

Result<SimulationRun> projectPlayed(const std::string& text, const SimulateOptions& options,
                                    const CliContext& context) {
    const Result<Project> project = readProjectText(text);
    if (!project) return project.error();
    std::vector<std::string> notices;
    Result<SimulationRun> run = onTerminal(options, context, [&](const TaskContext& task) -> Result<SimulationRun> {
        const Result<ProjectInPlay> play =
            projectInPlay(*project, options.play, context, {.cancel = task.cancel, .threads = task.threads});
        if (!play) return play.error();
        return played(*play, {planOf(options), options.play, !options.record.empty()}, task, notices);
    });
    for (const std::string& notice : notices) context.err << notice << '\n';
    return run;
}

Status simulate(const SimulateOptions& options, const CliContext& context) {
    const Result<std::string> text = readInput(options.input, context);
    if (!text) return text.error();
    const Result<BodyScene> scene = readBodyScene(*text);
    const bool isProject = !scene && scene.error().code == ErrorCode::Unsupported;
    if (!scene && !isProject) return scene.error();
    const Result<SimulationRun> run =
        isProject ? projectPlayed(*text, options, context) : bodiesSimulated(*scene, options, context);
    if (!run) return run.error();
    if (!options.trace.empty()) {
        if (const Status written = writeOutput(options.trace, run->trace, context); !written) return written;
    }
    if (run->replay) {
        if (const Status written = saveReplay(options.record, *run->replay); !written) return written;
    }
    return writeOutput("-", simulationJson(run->outcome), context);
}

}  // namespace

Verb addSimulate(CLI::App& program) {
    CLI::App* command = program.add_subcommand("simulate", "Let a project or plain bodies move, collide and break");
    const auto options = std::make_shared<SimulateOptions>();
    command->footer(kFooter);
    command->add_option("FILE", options->input, "The project or bodies: standard input if not given, or -")
        ->type_name("");
    command->add_option("--steps", options->steps, "How many steps to simulate")
        ->required()
        ->check(numberBetween(1, kMostSteps))
        ->option_text("N");
    addPlayOptions(*command, options->play);
    command->add_option("--record", options->record, "Write down what rubble-cli replay plays again")
        ->option_text("FILE");
    addThreadsOption(*command, options->threads);
    command->add_flag("--no-sleep", options->play.isSleepless, "Keep on moving bodies that have come to rest");
    command->add_option("--trace", options->trace, "Write a row a step: counts and energies in joule")
        ->option_text("FILE.csv");
    command->add_flag("--timings", options->isTimed, "Tell how long steps took, and in the trace each stage of them");
    return {command, [options](const CliContext& context) { return simulate(*options, context); }};
}

}  // namespace rubble
