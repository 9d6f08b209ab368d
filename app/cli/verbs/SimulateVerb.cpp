#include "app/cli/console/InputOutput.h"
#include "app/cli/console/ProgressLine.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/output/ProjectLoading.h"
#include "app/cli/simulation/BodySimulation.h"
#include "app/cli/simulation/ProjectSimulation.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/project/Ranges.h"
#include "core/io/play/BodiesJson.h"
#include "core/io/play/ReplayFile.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"

#include <memory>

namespace rubble {
namespace {

constexpr const char* kSimulateFooter =
    R"(Input, from FILE or standard input: a project, or a scene of bodies:
  {"gravity":[x,y,z],"bodies":[{"name":s,"kind":"dynamic","density":d,"friction":f,"restitution":r,
   "position":[x,y,z],"orientation":[w,x,y,z],"velocity":[x,y,z],"angularVelocity":[x,y,z],
   "hulls":[[[x,y,z],...],...]},...]}
"kind" is dynamic, static or kinematic. Position and orientation place the frame of the hulls in the world;
velocities are in world axes, the linear one at the centre of mass. Only "name" and "hulls" are required. Units
are metres, kilograms, seconds and radians; y is up. The instances of a project stand on its ground; --shot and
--shots fire shots at them.

Output:
  {"steps":N,"bodies":[{"name":s,"position":[x,y,z],"orientation":[w,x,y,z],"asleep":false},...],
   "counts":{"bodies":n,"pairs":n,"contactPoints":n},"swaps":n,"breaks":[...],"splits":[...],
   "largestPenetration":d,"hash":"..."}
Counts are means over the last 120 steps; the penetration is exact, of the final poses. A break is
  {"step":k,"body":s,"impact":J,"threshold":J,"point":[x,y,z],"fragments":n}, with --timings also "swapMilliseconds".
Where bonds break, which bonded assets do instead, a split is
  {"step":k,"body":s,"impulse":J,"point":[x,y,z],"bonds":n,"area":A,"freed":n}.
The bodies of a project are its instances, then projectiles and fragments in order of creation. The result does
not depend on the number of threads: equal inputs give equal hashes. --events writes one JSON object a line, or CSV
into FILE.csv; see docs/formats/events.md.

Examples:
  rubble-cli simulate house.json --steps 600 > after.json
  rubble-cli simulate house.json --steps 600 --trace steps.csv --timings
  rubble-cli simulate house.rubble --steps 600 --shot "box at the door"
  rubble-cli simulate house.rubble --steps 300 --shot "box at the door" --animation hit.glb > after.json
  rubble-cli simulate house.rubble --steps 60 --save-state standing.rubblestate
  rubble-cli simulate house.rubble --steps 600 --state standing.rubblestate --shot "box at the door")";

struct SimulateOptions {
    std::string input = "-";
    std::string trace;
    int steps = 0;
    int threads = 1;
    bool isTimed = false;
    std::string record;
    std::string events;
    std::string eventsVersion = "2";
    std::string wav;
    AnimationOptions animation;
    std::string state;
    std::string remapped;
    std::string savedState;
    bool isSmall = false;
    PlayOptions play;
};

SimulationPlan planOf(const SimulateOptions& options) {
    return {.steps = options.steps,
            .stepLength = options.play.stepLength,
            .world = {.sleeping = !options.play.isSleepless, .threads = options.threads},
            .isTraced = !options.trace.empty(),
            .isTimed = options.isTimed};
}

PlayPlan playPlan(const SimulateOptions& options) {
    PlayPlan plan{.simulation = planOf(options),
                  .play = options.play,
                  .isRecorded = !options.record.empty(),
                  .isHeard = !options.wav.empty(),
                  .animation = options.animation,
                  .state = options.state,
                  .remapped = options.remapped,
                  .savedState = options.savedState,
                  .savedKind = options.isSmall ? StateKind::Small : StateKind::Whole};
    if (!options.events.empty()) plan.events = eventsFormatOf(options.events);
    if (plan.events == EventsFormat::Stream && options.eventsVersion == "1") plan.events = EventsFormat::JsonLines;
    return plan;
}

/// Runs `work` and shows its progress on the terminal.
template <class Work>
Result<SimulationRun> withProgress(const SimulateOptions& options, const CliContext& context, const Work& work) {
    ProgressLine line(context, "Simulating");
    Result<SimulationRun> result = work(TaskContext{.cancel = context.cancel,
                                                    .progress = [&](double fraction) { line.show(fraction); },
                                                    .threads = options.threads});
    line.clear();
    return result;
}

Result<SimulationRun> simulateBodies(const BodyScene& scene, const SimulateOptions& options,
                                     const CliContext& context) {
    const ShotOptions& shots = options.play.shots;
    if (!shots.names.empty() || !shots.file.empty() || options.play.isWithoutDestruction || !options.record.empty() ||
        !options.events.empty()) {
        return Error{ErrorCode::BadInput,
                     "A scene of bodies has no shots, breaks and events and cannot be recorded; use a project."};
    }
    if (!options.wav.empty()) {
        return Error{ErrorCode::BadInput, "A scene of bodies has no materials that sound; use a project for --wav."};
    }
    if (!options.animation.file.empty()) {
        return Error{ErrorCode::BadInput, "A scene of bodies has no meshes; use a project for --animation."};
    }
    if (!options.state.empty() || !options.savedState.empty()) {
        return Error{ErrorCode::BadInput, "A scene of bodies has no states; use a project."};
    }
    std::vector<Diagnostic> diagnostics;
    Result<SimulationRun> run = withProgress(options, context, [&](const TaskContext& task) {
        return runBodies(scene, planOf(options), task, diagnostics);
    });
    printMessages(diagnostics, context);
    return run;
}

Result<SimulationRun> simulateProject(const std::string& text, const SimulateOptions& options,
                                      const CliContext& context) {
    std::vector<Diagnostic> notes;
    const bool isFile = options.input != "-";
    const Result<Project> project =
        readProjectText(text, &notes, isFile ? meshesIn(meshFolderOf(options.input)) : MeshSource());
    if (!project) return project.error();
    printNotes(notes, *project, options.input, context);
    std::vector<Diagnostic> diagnostics;
    Result<SimulationRun> run = withProgress(options, context, [&](const TaskContext& task) -> Result<SimulationRun> {
        const Result<PreparedProject> play =
            prepareProject(*project, options.play, context, {.cancel = task.cancel, .threads = task.threads});
        if (!play) return play.error();
        Result<SimulationRun> done = runProject(*play, playPlan(options), task, diagnostics);
        if (!done || !done->tracks) return done;
        const Status written = saveAnimation(options.animation.file, play->scene->project, *done->tracks, task);
        if (!written) return written.error();
        return done;
    });
    printMessages(diagnostics, context);
    if (run) {
        for (const std::string& note : run->notes) context.err << note << '\n';
    }
    return run;
}

Status simulate(const SimulateOptions& options, const CliContext& context) {
    if (const Status valid = checkAnimation(options.animation); !valid) return valid;
    const Result<std::string> text = readInput(options.input, context);
    if (!text) return text.error();
    const Result<BodyScene> scene = readBodyScene(*text);
    const bool isProject = !scene && scene.error().code == ErrorCode::Unsupported;
    if (!scene && !isProject) return scene.error();
    const Result<SimulationRun> run =
        isProject ? simulateProject(*text, options, context) : simulateBodies(*scene, options, context);
    if (!run) return run.error();
    if (!options.trace.empty()) {
        if (const Status written = writeOutput(options.trace, run->trace, context); !written) return written;
    }
    if (!options.events.empty()) {
        if (const Status written = writeOutput(options.events, run->events, context); !written) return written;
    }
    if (run->replay) {
        if (const Status written = saveReplay(options.record, *run->replay); !written) return written;
    }
    if (run->sound) {
        if (const Status written = writeFileAtomically(options.wav, wavFile(*run->sound)); !written) return written;
    }
    return printText(simulationJson(run->outcome), context);
}

}  // namespace

Verb addSimulate(CLI::App& program) {
    Command command(program, "simulate", "Simulate a project or a scene of bodies", kSimulateFooter);
    const auto options = std::make_shared<SimulateOptions>();
    command.argument("FILE", options->input, "The project or scene (default: -, standard input)").reads();
    command.option("-n,--steps", options->steps, "The number of steps to simulate; 0 prints the start")
        .required()
        .wholeInRange(ProjectNumber::Step)
        .valueName("N");
    addPlayOptions(command, options->play);
    command.option("--record", options->record, "Write a recording for rubble-cli replay")
        .writes({".replay", ".json"})
        .valueName("FILE");
    const CommandOption events =
        command
            .option("--events", options->events,
                    "Write which bodies there are, and what hit, broke and slid: JSON lines, or FILE.csv")
            .writes({".jsonl", ".json", ".csv"})
            .valueName("FILE");
    command
        .option("--events-version", options->eventsVersion, "The version of JSON lines of events, 1 or 2 (default: 2)")
        .needs(events)
        .oneOf({"1", "2"})
        .valueName("N");
    command.option("--wav", options->wav, "Write the sound of impacts and breaks")
        .writes({".wav"})
        .valueName("FILE.wav");
    addAnimationOptions(command, options->animation);
    const CommandOption state =
        command.option("--state", options->state, "Start from a saved state; times of shots count from there")
            .reads()
            .valueName("FILE");
    command.option("--remap", options->remapped, "Take only the damage of the state, which is of this earlier version")
        .reads()
        .needs(state)
        .valueName("FILE.rubble");
    const CommandOption saved =
        command.option("--save-state", options->savedState, "Write the state after the last step")
            .writes({".rubblestate"})
            .valueName("FILE");
    command.flag("--small", options->isSmall, "Save damage and resting poses only").needs(saved);
    addThreadsOption(command, options->threads);
    command.flag("--no-sleep", options->play.isSleepless, "Do not let bodies at rest sleep");
    for (const char* name : {"--dt", "--no-destruction", "--record", "--no-sleep"}) state.excludes(command[name]);
    command.option("--trace", options->trace, "Write counts and energies (J) of each step")
        .writes({".csv"})
        .valueName("FILE.csv");
    command.flag("--timings", options->isTimed, "Add the durations of steps and of their stages to the trace");
    return {command, [options](VerbReport&, const CliContext& context) { return simulate(*options, context); }};
}

}  // namespace rubble
