#include "app/cli/BodySimulation.h"
#include "app/cli/CommonOptions.h"
#include "app/cli/ProgressLine.h"
#include "app/cli/Verb.h"
#include "core/io/BodiesJson.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace rubble {
namespace {

constexpr const char* kFooter = R"(Input, from FILE or standard input:
  {"gravity":[x,y,z],"bodies":[{"name":s,"kind":"dynamic","density":d,"friction":f,"restitution":r,
   "position":[x,y,z],"orientation":[w,x,y,z],"velocity":[x,y,z],"angularVelocity":[x,y,z],
   "hulls":[[[x,y,z],...],...]},...]}
"kind" is dynamic, static or kinematic; position and orientation place the frame of the hulls in the world; velocities
are in world axes, the linear one that of the centre of mass. All but "name" and "hulls" may be left out. Metres,
kilograms, seconds, radians; y points up.

Output:
  {"steps":N,"bodies":[{"name":s,"position":[x,y,z],"orientation":[w,x,y,z],"asleep":false},...],
   "counts":{"bodies":n,"pairs":n,"contactPoints":n},"swaps":n,"breaks":[...],"largestPenetration":d,"hash":"..."}
Counts are means over the last 120 steps; the penetration is exact, on the final poses. The same input gives the same
bits on any number of threads: compare hashes.

Examples:
  rubble-cli simulate house.json --steps 600 > after.json
  rubble-cli simulate house.json --steps 600 --trace steps.csv --timings)";

// Beyond this nobody waits for the end.
constexpr int kMostSteps = 10'000'000;
// s: shorter steps drown in rounding, longer ones are no motion any more.
constexpr double kShortestStep = 1e-5;
constexpr double kLongestStep = 0.1;

struct SimulateOptions {
    std::string input = "-";
    std::string trace;
    int steps = 0;
    double stepLength = 1.0 / 60.0;
    int threads = 1;
    bool isSleepless = false;
    bool isTimed = false;
};

Result<BodySimulation> simulatedOnTerminal(const BodyScene& scene, const SimulateOptions& options,
                                           const CliContext& context) {
    ProgressLine line(context, "Simulating");
    const SimulationPlan plan{.steps = options.steps,
                              .stepLength = options.stepLength,
                              .world = {.sleeping = !options.isSleepless, .threads = options.threads},
                              .isTraced = !options.trace.empty(),
                              .isTimed = options.isTimed};
    Result<BodySimulation> result =
        simulated(scene, plan, {.cancel = context.cancel, .progress = [&](double fraction) { line.show(fraction); }});
    line.clear();
    return result;
}

Status simulate(const SimulateOptions& options, const CliContext& context) {
    const Result<std::string> text = readInput(options.input, context);
    if (!text) return text.error();
    const Result<BodyScene> scene = readBodyScene(*text);
    if (!scene) return scene.error();
    const Result<BodySimulation> simulation = simulatedOnTerminal(*scene, options, context);
    if (!simulation) return simulation.error();
    if (!options.trace.empty()) {
        if (const Status written = writeOutput(options.trace, simulation->trace, context); !written) return written;
    }
    return writeOutput("-", simulationJson(simulation->outcome), context);
}

}  // namespace

Verb addSimulate(CLI::App& program) {
    CLI::App* command = program.add_subcommand("simulate", "Let bodies move, fall and collide, JSON to JSON");
    const auto options = std::make_shared<SimulateOptions>();
    command->footer(kFooter);
    command->add_option("FILE", options->input, "The bodies: standard input if not given, or -")->type_name("");
    command->add_option("--steps", options->steps, "How many steps to simulate")
        ->required()
        ->check(numberBetween(1, kMostSteps))
        ->option_text("N");
    command->add_option("--dt", options->stepLength, "The length of a step in seconds: 1/60 if not given")
        ->check(numberBetween(kShortestStep, kLongestStep))
        ->option_text("S");
    addThreadsOption(*command, options->threads);
    command->add_flag("--no-sleep", options->isSleepless, "Keep on moving bodies that have come to rest");
    command->add_option("--trace", options->trace, "Write a row a step: counts and energies in joule")
        ->option_text("FILE.csv");
    command->add_flag("--timings", options->isTimed, "Tell how long steps took, and in the trace each stage of them");
    return {command, [options](const CliContext& context) { return simulate(*options, context); }};
}

}  // namespace rubble
