#include "app/cli/console/InputOutput.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/options/PlayOptions.h"
#include "app/cli/output/ProjectLoading.h"
#include "app/cli/verbs/Verb.h"
#include "core/base/MessageText.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/play/StateFile.h"
#include "core/io/system/AtomicFile.h"
#include "core/play/damage/DamageBytes.h"

#include <algorithm>
#include <memory>

namespace rubble {
namespace {

constexpr const char* kDamageFooter =
    R"(The damage of an instance: which of its fractures or bonds have broken, without bodies and poses, in at most 64
bytes and a bit for each; for saves and networks. See docs/formats/state.md.
  write    of an instance in a state of --project, or of the intact one, to the file of --out
  apply    to the instances of --project, one --instance for each FILE; writes the state to --out
  merge    what is broken in one of the files, in any order and number, to --out
  compare  two files: what is broken in the second one and not in the first, which --out gets, too

Output of write, merge and compare; compare ends with status 3 where they differ:
  {"kind":"bonds","bake":s,"count":n,"broken":n,"weakened":n}

Examples:
  rubble-cli damage write --project arcade.rubble --state hit.rubblestate --instance arcade --out arcade.rubbledamage
  rubble-cli damage apply arcade.rubbledamage --project arcade.rubble --instance arcade --out again.rubblestate
  rubble-cli damage merge mine.rubbledamage theirs.rubbledamage --out both.rubbledamage
  rubble-cli damage compare before.rubbledamage after.rubbledamage --out since.rubbledamage)";

struct DamageOptions {
    std::string action;
    std::vector<std::string> files;
    std::string project;
    std::vector<std::string> instances;
    std::string state;
    std::string out;
    int threads = 1;
};

std::string summaryOf(const InstanceDamage& damage) {
    JsonWriter json(JsonLayout::Inline);
    json.openObject();
    json.text("kind", damage.kind == DamageKind::Bonds ? "bonds" : "fractures");
    json.text("bake", damage.bake.hex());
    json.wholeNumber("count", std::uint64_t{damage.broken.size()});
    json.wholeNumber("broken", static_cast<std::uint64_t>(std::ranges::count(damage.broken, true)));
    json.wholeNumber("weakened", std::uint64_t{damage.partial.size()});
    json.close();
    return std::move(json).finished();
}

Error withFile(const std::string& file, const Error& error) {
    return {error.code, quotedPath(file) + ": " + error.message};
}

Result<InstanceDamage> readDamage(const std::string& file, const CliContext& context) {
    const Result<std::string> bytes = readInput(file, context);
    if (!bytes) return bytes.error();
    Result<InstanceDamage> damage = damageOfBytes(*bytes);
    if (!damage) return withFile(file, damage.error());
    return damage;
}

Result<Id> instanceNamed(const Project& project, const std::string& name) {
    const auto found = std::ranges::find(project.instances, name, &Instance::name);
    if (found != project.instances.end()) return found->id;
    return Error{ErrorCode::NotFound,
                 "The project has no instance " + quotedName(name) + "; " + quotedNamesOf(project.instances) + "."};
}

/// A session of the project, at the moment of --state.
Result<Session> sessionOf(const DamageOptions& options, const CliContext& context) {
    const Result<Project> project = openProject(options.project, context);
    if (!project) return project.error();
    const PlayOptions play;
    const Result<PreparedProject> ready =
        prepareProject(*project, play, context, {.cancel = context.cancel, .threads = options.threads});
    if (!ready) return ready.error();
    if (options.state.empty()) return createSession(*ready, play, options.threads);
    return loadState(options.state, ready->scene, {.threads = options.threads});
}

Status writeDamage(const DamageOptions& options, const CliContext& context) {
    const Result<Session> session = sessionOf(options, context);
    if (!session) return session.error();
    const Result<Id> instance = instanceNamed(session->scene().project, options.instances.front());
    if (!instance) return instance.error();
    const SessionDamage all = session->damage();
    const InstanceDamage& damage = all.at(*instance);
    if (damage.broken.empty()) {
        return Error{ErrorCode::BadInput,
                     "Instance " + quotedName(options.instances.front()) + " does not break; it has no damage."};
    }
    if (const Status written = writeOutput(options.out, damageBytes(damage), context); !written) return written;
    return printText(summaryOf(damage), context);
}

Status applyDamages(const DamageOptions& options, const CliContext& context) {
    Result<Session> session = sessionOf(options, context);
    if (!session) return session.error();
    SessionDamage all;
    for (std::size_t k = 0; k < options.files.size(); ++k) {
        const Result<Id> instance = instanceNamed(session->scene().project, options.instances[k]);
        if (!instance) return instance.error();
        Result<InstanceDamage> damage = readDamage(options.files[k], context);
        if (!damage) return damage.error();
        if (!all.emplace(*instance, std::move(*damage)).second) {
            return Error{ErrorCode::BadInput,
                         "Instance " + quotedName(options.instances[k]) + " is named twice; merge its damages first."};
        }
    }
    if (const Status applied = session->apply(all); !applied) return applied;
    printMessages(session->events().diagnostics, context);
    return saveState(options.out, *session, StateKind::Whole);
}

Status mergeDamages(const DamageOptions& options, const CliContext& context) {
    Result<InstanceDamage> merged = readDamage(options.files.front(), context);
    for (std::size_t k = 1; merged && k < options.files.size(); ++k) {
        const Result<InstanceDamage> other = readDamage(options.files[k], context);
        if (!other) return other.error();
        merged = mergedDamage(*merged, *other);
        if (!merged) return withFile(options.files[k], merged.error());
    }
    if (!merged) return merged.error();
    if (const Status written = writeOutput(options.out, damageBytes(*merged), context); !written) return written;
    return printText(summaryOf(*merged), context);
}

Status compareDamages(const DamageOptions& options, VerbReport& report, const CliContext& context) {
    const Result<InstanceDamage> before = readDamage(options.files[0], context);
    if (!before) return before.error();
    const Result<InstanceDamage> after = readDamage(options.files[1], context);
    if (!after) return after.error();
    const Result<InstanceDamage> added = damageSince(*after, *before);
    if (!added) return withFile(options.files[1], added.error());
    if (!options.out.empty()) {
        if (const Status written = writeOutput(options.out, damageBytes(*added), context); !written) return written;
    }
    if (*before != *after) conclude(report, "The damages differ.");
    return printText(summaryOf(*added), context);
}

/// Why options do not fit the action, as a sentence; empty if they do.
std::string optionFault(const DamageOptions& options) {
    const std::string& action = options.action;
    const bool isOfProject = action == "write" || action == "apply";
    if (isOfProject == options.project.empty())
        return isOfProject ? action + " needs --project." : action + " does not take --project.";
    if (action != "compare" && options.out.empty()) return action + " needs --out.";
    if (!isOfProject && !options.state.empty()) return action + " does not take --state.";
    if (action == "write" && (options.instances.size() != 1 || !options.files.empty()))
        return "write takes one --instance and no FILE.";
    if (action == "apply" && (options.files.empty() || options.files.size() != options.instances.size()))
        return "apply takes a FILE for each --instance, in the same order.";
    if (!isOfProject && !options.instances.empty()) return action + " does not take --instance.";
    if (action == "merge" && options.files.empty()) return "merge takes the files to merge.";
    if (action == "compare" && options.files.size() != 2) return "compare takes two files.";
    return {};
}

Status damage(const DamageOptions& options, VerbReport& report, const CliContext& context) {
    if (options.action == "write") return writeDamage(options, context);
    if (options.action == "apply") return applyDamages(options, context);
    if (options.action == "merge") return mergeDamages(options, context);
    return compareDamages(options, report, context);
}

}  // namespace

Verb addDamage(CLI::App& program) {
    Command command(program, "damage", "Write, apply, merge or compare what has broken", kDamageFooter);
    const auto options = std::make_shared<DamageOptions>();
    command.argument("ACTION", options->action, "write, apply, merge or compare")
        .required()
        .oneOf({"write", "apply", "merge", "compare"})
        .valueName(" ");
    command.argument("FILE", options->files, "Damages, as write writes them").reads();
    command.option("--project", options->project, "The project of the instances").reads().valueName("FILE");
    command.option("--instance", options->instances, "The name of an instance; repeatable")
        .repeatable()
        .valueName("NAME");
    command.option("--state", options->state, "The state to begin with (default: the start)").reads().valueName("FILE");
    command.option("-o,--out", options->out, "The file to write")
        .writes({".rubbledamage", ".rubblestate"})
        .valueName("FILE");
    addThreadsOption(command, options->threads);
    command.requireFit([options] { return optionFault(*options); });
    return {command,
            [options](VerbReport& report, const CliContext& context) { return damage(*options, report, context); }};
}

}  // namespace rubble
