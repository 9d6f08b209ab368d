#include "app/cli/console/InputOutput.h"
#include "app/cli/console/ProgressLine.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/options/PlayOptions.h"
#include "app/cli/output/ProjectLoading.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/project/Ranges.h"
#include "core/base/MessageText.h"
#include "core/io/play/QueryJson.h"
#include "core/play/queries/ChangeRecorder.h"

#include <algorithm>
#include <memory>
#include <optional>

namespace rubble {
namespace {

constexpr const char* kQueryFooter =
    R"(Simulates a project for --steps, then asks:
  would-fall      which bodies at rest come free where those of --body are removed, or are brought down by these;
                  of a bonded body, also a fragment can be removed, by its name: "wall/3.5"
  changed-boxes   where something moved, broke or came to rest since the step of --since, for navigation meshes

Output of would-fall, in kg and s; bodies are bodies and fragments; first and last are when falling ones meet what
stays, null for never:
  {"step":N,"removed":[s,...],"islands":[{"mass":m,"bodies":[s,...]},...],"mass":m,"first":t,"last":t}
Output of changed-boxes, in m; boxes that overlap are merged:
  {"since":K,"step":N,"boxes":[{"min":[x,y,z],"max":[x,y,z]},...]}

Examples:
  rubble-cli query house.rubble would-fall --steps 120 --body "front 1.1" --body "front 1.2"
  rubble-cli query arcade.rubble would-fall --steps 60 --body arcade/3.42
  rubble-cli query house.rubble changed-boxes --steps 600 --since 540 --shot "box at the door")";

struct QueryOptions {
    std::string file;
    std::string question;
    std::vector<std::string> bodies;
    int steps = 0;
    int since = 0;
    int threads = 1;
    PlayOptions play;
};

/// The body with a name, or the one in which the fragment with it is bonded; nothing if there is none.
std::optional<BodyPart> partNamed(const Session& session, const std::string& name) {
    const auto found =
        std::ranges::find_if(session.bodies(), [&](const PlayBody& body) { return session.nameOf(body) == name; });
    if (found != session.bodies().end()) return BodyPart{.body = found->number};
    for (const PlayBody& body : session.bodies()) {
        const PlayOrigin& origin = session.origins()[body.origin];
        if (!name.starts_with(origin.name + '/')) continue;
        for (const std::uint32_t fragment : bondedFragments(body)) {
            if (fragmentName(body, origin, fragment) == name) return BodyPart{body.number, {fragment}};
        }
    }
    return std::nullopt;
}

/// The bodies and fragments with these names, in their order.
Result<std::vector<BodyPart>> partsNamed(const Session& session, const std::vector<std::string>& names) {
    std::vector<BodyPart> parts;
    for (const std::string& name : names) {
        std::optional<BodyPart> part = partNamed(session, name);
        if (!part) {
            return Error{ErrorCode::NotFound, "There is no body or bonded fragment " + quotedName(name) + " at step " +
                                                  std::to_string(session.stepsDone()) +
                                                  "; rubble-cli simulate prints the names of all bodies."};
        }
        parts.push_back(std::move(*part));
    }
    return parts;
}

Result<std::string> answer(const QueryOptions& options, Session& session, const CliContext& context,
                           const TaskContext& task) {
    const auto steps = static_cast<std::uint64_t>(options.steps), since = static_cast<std::uint64_t>(options.since);
    if (options.question == "would-fall") {
        if (const Status played = simulateTo(session, steps, context, task); !played) return played.error();
        const Result<std::vector<BodyPart>> removed = partsNamed(session, options.bodies);
        if (!removed) return removed.error();
        const Result<Collapse> collapse = wouldFall(session, *removed);
        if (!collapse) return collapse.error();
        return wouldFallJson(session, *removed, *collapse);
    }
    if (const Status played = simulateTo(session, since, context, task); !played) return played.error();
    ChangeRecorder recorder(session);
    while (session.stepsDone() < steps) {
        if (const Status played = simulateTo(session, session.stepsDone() + 1, context, {.cancel = task.cancel});
            !played) {
            return played.error();
        }
        recorder.add(session);
    }
    return changedBoxesJson(since, steps, recorder.changedBoxes(since));
}

/// Why options do not fit the question, as a sentence; empty if they do. Those of the other question would have no
/// effect.
std::string optionFault(const QueryOptions& options) {
    const bool isFall = options.question == "would-fall";
    if (isFall && options.bodies.empty()) return "would-fall needs --body, the name of a body to remove.";
    if (!isFall && !options.bodies.empty()) return "changed-boxes does not take --body, which would-fall does.";
    if (isFall && options.since != 0) return "would-fall does not take --since, which changed-boxes does.";
    if (options.since <= options.steps) return {};
    return "The changes would start at step " + std::to_string(options.since) + " and end at step " +
           std::to_string(options.steps) + ".";
}

Status query(const QueryOptions& options, const CliContext& context) {
    const Result<Project> project = openProject(options.file, context);
    if (!project) return project.error();
    ProgressLine line(context, "Simulating");
    const TaskContext task{.cancel = context.cancel,
                           .progress = [&](double fraction) { line.show(fraction); },
                           .threads = options.threads};
    const Result<PreparedProject> play =
        prepareProject(*project, options.play, context, {.cancel = task.cancel, .threads = task.threads});
    if (!play) return play.error();
    Result<Session> session = createSession(*play, options.play, options.threads);
    if (!session) return session.error();
    const Result<std::string> text = answer(options, *session, context, task);
    line.clear();
    return text ? printText(*text, context) : text.error();
}

}  // namespace

Verb addQuery(CLI::App& program) {
    Command command(program, "query", "Ask what would fall, or where a simulation changed", kQueryFooter);
    const auto options = std::make_shared<QueryOptions>();
    addProjectArgument(command, options->file);
    command.argument("QUESTION", options->question, "would-fall or changed-boxes")
        .required()
        .oneOf({"would-fall", "changed-boxes"})
        .valueName(" ");
    command.option("-n,--steps", options->steps, "The number of steps to simulate")
        .required()
        .wholeInRange(ProjectNumber::Step)
        .valueName("N");
    command.option("--body", options->bodies, "The name of a body or of a bonded fragment to remove; repeatable")
        .repeatable()
        .valueName("NAME");
    command.option("--since", options->since, "The step since which changes are listed (default: 0)")
        .wholeInRange(ProjectNumber::Step)
        .valueName("STEP");
    addPlayOptions(command, options->play);
    addThreadsOption(command, options->threads);
    command.requireFit([options] { return optionFault(*options); });
    return {command, [options](VerbReport&, const CliContext& context) { return query(*options, context); }};
}

}  // namespace rubble
