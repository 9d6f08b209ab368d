#include "app/cli/Cli.h"

#include "app/cli/console/InputOutput.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/verbs/Verb.h"
#include "core/base/MessageText.h"
#include "core/base/OutOfMemory.h"
#include "core/base/Version.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <ostream>

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
       not clean, replay diverges, diff found differences
  130  stopped by Ctrl+C

Examples:
  rubble-cli new wall.rubble
  rubble-cli import crate.glb --into wall.rubble
  rubble-cli draw wall.rubble --out wall.svg
  rubble-cli render wall.rubble --out wall.png
  rubble-cli export wall.rubble --out packs)";

std::string verbNames(const CLI::App& program) {
    std::vector<std::string> names;
    for (const CLI::App* verb : program.get_subcommands({})) names.push_back(verb->get_name());
    return joinedText(names);
}

/// Returns the error message for arguments that no option accepts.
std::string extrasError(const CLI::App& program) {
    const std::vector<std::string> extras = program.remaining(true);
    const bool isVerb = program.get_subcommands().empty() && !extras.front().starts_with('-');
    if (isVerb) return quotedName(extras.front()) + " is not a verb; the verbs are " + verbNames(program);
    return "Unexpected arguments: " + joinedText(extras);
}

/// Returns the first line of a parse error as one sentence with a hint on --help.
std::string usageError(const CLI::App& program, const CLI::ParseError& error) {
    const bool hasExtras = error.get_exit_code() == static_cast<int>(CLI::ExitCodes::ExtrasError);
    std::string sentence = hasExtras ? extrasError(program) : error.what();
    sentence.erase(std::min(sentence.find('\n'), sentence.size()));
    while (!sentence.empty() && (sentence.back() == '.' || sentence.back() == ' ')) sentence.pop_back();
    std::string help = "rubble-cli";
    for (const CLI::App* verb : program.get_subcommands()) help += " " + verb->get_name();
    return sentence + "; see " + help + " --help.";
}

/// Returns arguments with the present name of a verb that had another one.
std::vector<std::string> withPresentVerb(std::vector<std::string> arguments) {
    if (!arguments.empty() && arguments.front() == "film") arguments.front() = "video";
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
    VerbReport report{.isJson = verb.command.isReportWanted()};
    Status status = orOutOfMemory("running rubble-cli " + name, [&] { return verb.action(report, context); });
    if (report.isJson) {
        const Status printed = printText(reportJson(report, name, status), context);
        if (status) status = printed;
    }
    return finish(status, report, context);
}

}  // namespace

int runCli(const std::vector<std::string>& arguments, const CliContext& context) {
    const std::vector<std::string> present = withPresentVerb(arguments);
    CLI::App program(kDescription, "rubble-cli");
    program.footer(kProgramFooter);
    program.set_version_flag("--version", std::string("rubble-cli ") + programVersion(), "Print the version and exit");
    program.set_help_flag("-h,--help", "Print this help and exit");
    program.require_subcommand(0, 1);  // a missing verb is reported below
    program.get_formatter()->column_width(34);
    program.get_formatter()->label("SUBCOMMAND", "VERB");
    const std::vector<Verb> verbs = {
        addNew(program),    addImport(program), addSeeds(program),    addFracture(program), addExport(program),
        addCheck(program),  addDraw(program),   addRender(program),   addVideo(program),    addSimulate(program),
        addReplay(program), addTest(program),   addStrength(program), addAudit(program),    addMaterials(program),
        addDiff(program),   addSheet(program),  addQuery(program)};
    try {
        program.parse(
            std::vector<std::string>(present.rbegin(), present.rend()));  // CLI11 expects them in reverse order
    } catch (const CLI::Success& request) {
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

}  // namespace rubble
