#include "app/cli/Cli.h"

#include "app/cli/console/InputOutput.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/options/Suggestion.h"
#include "app/cli/verbs/Verb.h"
#include "core/base/MessageText.h"
#include "core/base/OutOfMemory.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <optional>
#include <ostream>
#include <span>
#include <utility>

namespace rubble {
namespace {

constexpr const char* kDescription =
    "Rubble makes solids destructible: it fractures prisms into Voronoi fragments and exports them to 3D programs and "
    "engines.";

constexpr const char* kProgramFooter = R"(Results go to standard output, errors and warnings to standard error.
Exit status:
  0    success
  1    error: a file cannot be read or written, bad input, out of memory
  2    wrong usage
  3    findings: check found faults, tests failed, requirements of strength are not satisfied, an asset of audit is
       not clean, replay diverges, diff or damage compare found differences
  130  stopped by Ctrl+C

rubble-cli VERB --help prints the options and examples of a verb.

Examples:
  rubble-cli new wall.rubble
  rubble-cli import crate.glb --into wall.rubble
  rubble-cli draw wall.rubble --out wall.svg
  rubble-cli render wall.rubble --out wall.png
  rubble-cli export wall.rubble --out packs)";

std::vector<std::string> verbNames(const CLI::App& program) {
    std::vector<std::string> names;
    for (const CLI::App* verb : program.get_subcommands({})) {
        if (!verb->get_group().empty()) names.push_back(verb->get_name());
    }
    return names;
}

/// Returns the long names of a command's options: "--out".
std::vector<std::string> optionNames(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
}

/// The verb that was given, or else the program.
const CLI::App& givenCommand(const CLI::App& program) {
    const std::vector<const CLI::App*> given =
        program.get_subcommands([](const CLI::App* verb) { return verb->parsed(); });
    return given.empty() ? program : *given.front();
}

/// Returns the call of a command: "rubble-cli export".
std::string callOf(const CLI::App& command) {
    return command.get_parent() == nullptr ? command.get_name() : "rubble-cli " + command.get_name();
}

/// Returns the error for an option that a command does not have.
std::string unknownOption(const std::string& typed, const CLI::App& command) {
    const std::string sentence = shownName(typed) + " is not an option of " + command.get_name();
    const std::string help = callOf(command) + " --help.";
    const auto suggestion = suggestionFor(typed, optionNames(command));
    return sentence + (suggestion ? "; did you mean " + *suggestion + "? See " : "; see ") + help;
}

std::string unknownVerb(const std::string& typed, const CLI::App& program) {
    const std::vector<std::string> verbs = verbNames(program);
    const auto suggestion = suggestionFor(typed, verbs);
    return quotedName(typed) + " is not a verb; " +
           (suggestion ? "did you mean " + *suggestion + "? See " : "the verbs are " + joinedText(verbs) + "; see ") +
           "rubble-cli --help.";
}

/// Returns the error for an unknown verb or option; nothing if there is none.
std::optional<std::string> unknownName(const CLI::App& program) {
    const std::vector<std::string> extras = program.remaining(true);
    const CLI::App& command = givenCommand(program);
    if (&command == &program && !extras.empty() && !extras.front().starts_with('-'))
        return unknownVerb(extras.front(), program);
    for (const std::string& extra : extras) {
        if (extra == "--") break;  // values follow
        if (extra.starts_with('-') && extra != "-") return unknownOption(extra.substr(0, extra.find('=')), command);
    }
    return std::nullopt;
}

/// Returns a parse error as one sentence with a hint on --help. What is mistyped comes before what is missing, which
/// often follows from it.
std::string usageError(const CLI::App& program, const CLI::ParseError& error) {
    if (std::optional<std::string> unknown = unknownName(program)) return *unknown;
    const bool hasExtras = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
    std::string sentence = hasExtras ? "Unexpected arguments: " + joinedText(program.remaining(true)) : error.what();
    sentence.erase(std::min(sentence.find('\n'), sentence.size()));
    while (!sentence.empty() && (sentence.back() == '.' || sentence.back() == ' ')) sentence.pop_back();
    return sentence + "; see " + callOf(givenCommand(program)) + " --help.";
}

/// Returns the arguments with --help in place of the verb "help".
std::vector<std::string> withHelpOption(std::vector<std::string> arguments) {
    if (!arguments.empty() && arguments.front() == "help") {
        arguments.erase(arguments.begin());
        arguments.resize(std::min<std::size_t>(arguments.size(), 1));
        arguments.emplace_back("--help");
    }
    return arguments;
}

/// Prints an error, or else what was found. Returns the exit status.
int finish(const Status& status, const VerbReport& report, const CliContext& context) {
    if (!status) {
        context.err << status.error().message << '\n';
        return status.error().code == ErrorCode::Cancelled ? kExitCancelled : kExitError;
    }
    if (report.conclusion.empty()) return kExitSuccess;
    context.err << report.conclusion << '\n';
    return kExitFindings;
}

/// Runs a verb and prints what it found and its document. Returns the exit status.
int run(const Verb& verb, const std::string& name, const CliContext& context) {
    VerbReport report{.isQuiet = verb.command.isQuiet(), .isJson = verb.command.isReportWanted()};
    std::ostream nowhere(nullptr);
    const CliContext quiet{.in = context.in,
                           .out = context.out,
                           .err = nowhere,
                           .programFolder = context.programFolder,
                           .cancel = context.cancel};
    Status status = checkFileUses(verb.command.fileUses());
    if (status) {
        status = orOutOfMemory("running rubble-cli " + name,
                               [&] { return verb.action(report, report.isQuiet ? quiet : context); });
    }
    if (report.isJson) {
        const Status printed = printText(reportJson(report, name, status), context);
        if (status) status = printed;
    }
    return finish(status, report, context);
}

/// Adds all verbs, in the order of the help.
std::vector<Verb> addVerbs(CLI::App& program) {
    std::vector<Verb> verbs = {addNew(program),       addImport(program),   addSeeds(program),    addClusters(program),
                               addFracture(program),  addExport(program),   addCheck(program),    addDraw(program),
                               addRender(program),    addVideo(program),    addSimulate(program), addReplay(program),
                               addTest(program),      addStrength(program), addAudit(program),    addMaterials(program),
                               addDiff(program),      addSheet(program),    addQuery(program),    addDamage(program),
                               addCompletion(program)};
    for (Verb& verb : verbs) verb.command.addCommonFlags();
    return verbs;
}

}  // namespace

int runCli(const std::vector<std::string>& arguments, const CliContext& context) {
    const std::vector<std::string> present = withHelpOption(arguments);
    CLI::App program(kDescription, "rubble-cli");
    program.footer(kProgramFooter);
    program.set_version_flag("--version", versionText(), "Print the version and exit");
    program.set_help_flag("-h,--help", "Print this help and exit");
    program.require_subcommand(0, 1);  // a missing verb is reported below
    program.get_formatter()->column_width(34);
    program.get_formatter()->label("SUBCOMMAND", "VERB");
    std::vector<Verb> verbs = addVerbs(program);
    try {
        program.parse(
            std::vector<std::string>(present.rbegin(), present.rend()));  // CLI11 expects them in reverse order
    } catch (const CLI::Success& request) {
        if (const auto unknown = unknownName(program)) {
            context.err << *unknown << '\n';
            return kExitUsage;
        }
        program.exit(request, context.out, context.err);
        return finish(printText("", context), {}, context);
    } catch (const CLI::ParseError& error) {
        context.err << usageError(program, error) << '\n';
        return kExitUsage;
    }
    const auto selected = std::ranges::find_if(verbs, [](const Verb& verb) { return verb.command.isParsed(); });
    if (selected == verbs.end()) {
        context.err << "No verb given; see rubble-cli --help.\n";
        return kExitUsage;
    }
    return run(*selected, program.get_subcommands().front()->get_name(), context);
}

std::vector<WrittenOption> writtenOptions() {
    CLI::App program;
    std::vector<WrittenOption> written;
    for (const Verb& verb : addVerbs(program)) {
        for (const std::string& option : verb.command.writtenOptions())
            written.push_back({verb.command.name(), option});
    }
    return written;
}

}  // namespace rubble
