#include "app/cli/console/FileWatch.h"
#include "app/cli/console/InputOutput.h"
#include "app/cli/console/ProgressLine.h"
#include "app/cli/options/AssetOptions.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/output/Depfile.h"
#include "app/cli/output/ExportOutcome.h"
#include "app/cli/output/ProjectLoading.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/project/Ranges.h"
#include "core/io/formats/ExportFormat.h"
#include "core/io/formats/ExportTarget.h"
#include "core/io/formats/TextureBaking.h"
#include "core/io/output/ExportIndex.h"
#include "core/io/pack/OutputFolder.h"
#include "core/io/pack/PackExport.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace rubble {
namespace {

namespace fs = std::filesystem;

constexpr const char* kExportFooter =
    R"(Writes each asset into a folder with its name: pack.json, which describes the whole and its fragments; meshes;
and manifest.json. A folder that already holds the same export is not rewritten; others are replaced as a whole,
unless a file in them was changed since or is not part of an export. Files that engines write beside meshes
(.import, .uid, .meta) are kept. export.json in the output folder lists the folders of the project; with
--prune, those of assets that were deleted or renamed are removed, unless a file in them was changed. If there
are many warnings, only the first three are printed; rubble-cli check prints all.

Examples:
  rubble-cli export house.rubble --out packs
  rubble-cli export house.rubble --out packs --prune --depfile packs.d --quiet
  rubble-cli export house.rubble --out packs --watch
  rubble-cli export house.rubble --out packs --asset wall --format obj --fragments files --place centred)";

struct ExportArguments {
    std::string project;
    std::string out;
    std::vector<std::string> assets;
    const ExportTarget* target = nullptr;
    PackOptions pack;
    std::optional<FormatSet> partFormats;           // of --format, in place of those of the program
    std::map<std::string_view, bool> addedFormats;  // by their own options
    bool isWithoutScene = false;
    bool isOverwriting = false;
    bool isDryRun = false;
    bool isPruning = false;
    bool isWatching = false;
    std::string depfile;  // empty: none
    int threads = 1;
};

/// Adds an option whose value is one of a few words; `set` gets the number of the word.
CommandOption addWordOption(Command& command, std::string_view name, std::string_view help,
                            const std::vector<std::string>& words, const std::function<void(std::size_t)>& set) {
    std::string label;
    for (const std::string& word : words) label += (label.empty() ? "" : "|") + word;
    const auto select = [words, set](const std::string& given) {
        set(static_cast<std::size_t>(std::ranges::find(words, given) - words.begin()));
    };
    return command.callback("--" + std::string(name), select, std::string(help)).oneOf(words).valueName(label);
}

using Names = std::vector<std::string>;

EditedFiles editedFiles(const ExportArguments& arguments) {
    return arguments.isOverwriting ? EditedFiles::Replaced : EditedFiles::Kept;
}

/// An error with what to do about it.
Error refusal(const Error& error) {
    return {error.code, error.message + (error.code == ErrorCode::Edited ? " Use --overwrite to replace it." : "")};
}

/// What the output folder is to hold.
OutputRequest requestOf(const ExportArguments& arguments) {
    return {.folder = arguments.out,
            .project = indexName(arguments.project),
            .isPruning = arguments.isPruning,
            .options = arguments.pack,
            .target = arguments.target,
            .hasAllAssets = arguments.assets.empty(),
            .isWithScene = !arguments.isWithoutScene,
            .edited = editedFiles(arguments)};
}

/// Refuses a dependency file that is one of the export: in the output folder with a name that the export uses, or in a
/// folder of it.
Status checkDepfile(const ExportArguments& arguments, const Project& project) {
    if (arguments.depfile.empty() || arguments.depfile == "-") return success();
    std::error_code ignored;
    const fs::path folder = fs::weakly_canonical(fs::absolute(arguments.out, ignored), ignored);
    const fs::path file = fs::weakly_canonical(fs::absolute(arguments.depfile, ignored), ignored);
    const fs::path inside = file.lexically_relative(folder);
    if (inside.empty() || *inside.begin() == "..") return success();
    const Names names = outputFileNames(requestOf(arguments), project);
    if (!inside.has_parent_path() && std::ranges::find(names, inside.string()) == names.end()) return success();
    return Error{ErrorCode::BadInput, "--depfile: " + quotedName(arguments.depfile) +
                                          " is a file of this export. Nothing was written; give another name."};
}

/// Writes that the manifests of all exported packs depend on the project.
Status writeDepfile(const ExportArguments& arguments, const ExportOutcome& outcome, const CliContext& context) {
    Names targets;
    for (const AssetExport& pack : outcome.packs) {
        if (pack.status) targets.push_back((pack.folder / kManifestName).string());
    }
    const Result<std::string> text = depfileText(targets, Names{arguments.project});
    return text ? writeOutput(arguments.depfile, *text, context) : text.error();
}

/// What an export would do.
Result<ExportOutcome> plan(const ExportArguments& arguments, const Project& project, std::span<const Id> assets,
                           const TaskContext& task) {
    const Result<std::optional<ExportIndex>> earlier = readExportIndex(arguments.out);
    if (!earlier) return earlier.error();
    Result<std::vector<AssetExport>> packs =
        planPacks(project, assets, arguments.out, arguments.pack, editedFiles(arguments), task);
    if (!packs) return packs.error();
    ExportOutcome outcome{.isPlanned = true, .packs = std::move(*packs), .pruned = {}};
    if (!arguments.isPruning) return outcome;
    for (const std::string& name : stalePacks(requestOf(arguments), project, *earlier)) {
        const fs::path folder = fs::path(arguments.out) / name;
        outcome.pruned.push_back({folder, checkRemovable(folder)});
    }
    return outcome;
}

Result<ExportOutcome> exportOrPlan(const ExportArguments& arguments, const Project& project, std::span<const Id> assets,
                                   const CliContext& context) {
    ProgressLine line(context, "Exporting");
    const TaskContext task{context.cancel, [&](double fraction) { line.show(fraction); }, arguments.threads};
    if (arguments.isDryRun) {
        Result<ExportOutcome> planned = plan(arguments, project, assets, task);
        line.clear();
        return planned;
    }
    Result<OutputExport> exported = exportToFolder(requestOf(arguments), project, assets, task);
    line.clear();
    if (!exported) return refusal(exported.error());
    return ExportOutcome{.packs = std::move(exported->packs),
                         .pruned = std::move(exported->pruned),
                         .renamed = std::move(exported->renamed),
                         .finished = std::move(exported->finished)};
}

/// Refuses textures that no file would hold.
Status checkTextures(const MeshOptions& meshes) {
    if (meshes.textures == SurfaceTextures::None || bakingBytes(meshes) > 0.0) return success();
    return Error{ErrorCode::BadInput,
                 "--textures baked: none of the files would have textures. Nothing was written; add --format glb or "
                 "--usd, without --glb compact."};
}

Status exportAssets(ExportArguments arguments, VerbReport& report, const CliContext& context) {
    FormatSet& formats = arguments.pack.meshes.formats;
    if (arguments.partFormats) {
        for (const ExportFormat* format : exportFormats()) {
            if (format->partFile != nullptr) formats.erase(format->word);
        }
        for (const std::string_view word : *arguments.partFormats) formats.insert(word);
    }
    for (const auto& [word, isAdded] : arguments.addedFormats) {
        if (isAdded) formats.insert(word);
    }
    if (const Status checked = checkTextures(arguments.pack.meshes); !checked) return checked.error();
    const Result<Project> project = openProject(arguments.project, context);
    if (!project) return project.error();
    const Result<std::vector<Id>> selected = selectedAssets(*project, arguments.assets);
    if (!selected) return selected.error();
    if (const Status checked = checkDepfile(arguments, *project); !checked) return checked.error();
    const Result<ExportOutcome> outcome = exportOrPlan(arguments, *project, *selected, context);
    if (!outcome) return outcome.error();
    Status listed = outcome->finished ? success() : Status(refusal(outcome->finished.error()));
    if (listed && !outcome->isPlanned && !arguments.depfile.empty())
        listed = writeDepfile(arguments, *outcome, context);
    const Status printed = printExport(*outcome, arguments.project, report, context);
    if (listed) return printed;
    if (printed) return listed;
    report.findings.push_back(findingOf(listed.error()));
    return Error{ErrorCode::BadInput, printed.error().message + "\n" + listed.error().message};
}

/// Exports once, and again whenever the project has changed, until the program is interrupted. Neither errors nor
/// findings end it.
Status watch(const ExportArguments& arguments, const VerbReport& report, const CliContext& context) {
    if (std::error_code missing; !fs::exists(arguments.project, missing)) {
        const Result<Project> project = openProject(arguments.project, context);
        if (!project) return project.error();
    }
    FileWatch file(arguments.project);
    while (file.waitForChange(context)) {
        VerbReport once{.isQuiet = report.isQuiet};
        const Status exported = exportAssets(arguments, once, context);
        const bool isInterrupted = !exported && exported.error().code == ErrorCode::Cancelled;
        if (!exported && !isInterrupted) context.err << exported.error().message << '\n';
        if (!once.conclusion.empty()) context.err << once.conclusion << '\n';
        context.out.flush();
    }
    return success();
}

/// Adds the options for the formats: --format for those with files of parts, which are the default, and one for each
/// other.
void addFormats(Command& command, ExportArguments& arguments) {
    std::vector<std::string> words;
    std::vector<FormatSet> sets;
    FormatSet all;
    for (const ExportFormat* format : exportFormats()) {
        if (format->partFile == nullptr) continue;
        words.emplace_back(format->word);
        sets.push_back({format->word});
        all.insert(format->word);
    }
    words.insert(words.end(), {"both", "none"});
    sets.insert(sets.end(), {all, {}});
    addWordOption(command, "format", "The mesh files to write (default: both)", words,
                  [&arguments, sets](std::size_t k) { arguments.partFormats = sets[k]; });
    for (const ExportFormat* format : exportFormats()) {
        if (format->partFile != nullptr) continue;
        bool& isAdded = arguments.addedFormats[format->word];
        command.flag("--" + std::string(format->word), isAdded, std::string(format->hint) + ", too");
    }
}

void addOption(Command& command, const ExportOption& option, PackOptions& options) {
    std::vector<std::string> words;
    for (const ExportOption::Value& value : option.values) words.emplace_back(value.word);
    const auto given = std::make_shared<int>(0);  // times
    const auto set = [&option, &options, given](std::size_t value) {
        option.set(options, value);
        ++*given;
    };
    addWordOption(command, option.word, option.help, words, set);
    if (option.formerWord.empty()) return;
    addWordOption(command, option.formerWord, option.help, words, set).hidden();
    const std::string both =
        "--" + std::string(option.formerWord) + " is the former name of --" + std::string(option.word);
    command.requireFit([given, both] { return *given > 1 ? both + ": give one of them" : std::string(); });
}

/// Adds the options for the output folder.
void addFolderOptions(Command& command, ExportArguments& arguments) {
    command.flag("--no-scene", arguments.isWithoutScene, "Leave out scene.json");
    command.flag("--overwrite", arguments.isOverwriting, "Replace files that were changed after an export");
    command.flag("--prune", arguments.isPruning, "Remove the exports of assets that were deleted or renamed");
    const CommandOption dryRun =
        command.flag("--dry-run", arguments.isDryRun, "Say what would be done, and write nothing");
    command.flag("--watch", arguments.isWatching, "Export again whenever the project changes, until interrupted")
        .excludes(dryRun);
}

}  // namespace

Verb addExport(CLI::App& program) {
    Command command(program, "export", "Fracture assets and write their packs and meshes", kExportFooter);
    const auto arguments = std::make_shared<ExportArguments>();
    addProjectArgument(command, arguments->project);
    command.option("-o,--out", arguments->out, "The output folder, with a subfolder for each asset")
        .required()
        .valueName("FOLDER");
    addAssetOption(command, arguments->assets);
    std::vector<std::string> programs;
    for (const ExportTarget& target : exportTargets()) programs.emplace_back(target.word);
    // Before the options that change what it sets: they are applied in this order.
    addWordOption(command, "for", "Write what a program needs, with a README.md for it", programs, [arguments](auto k) {
        arguments->target = &exportTargets()[k];
        arguments->pack = arguments->target->options();
    });
    addFormats(command, *arguments);
    for (const ExportOption* option : exportOptions()) addOption(command, *option, arguments->pack);
    command.option("--inset", arguments->pack.inset, "The inset of collision hulls in m (default: 0.0001)")
        .inRange(ProjectNumber::HullInset)
        .valueName("LENGTH");
    command.flag("--short-names", arguments->pack.hasShortNames,
                 "Cut names at 32 bytes, for Blender's names and Windows's paths");
    addFolderOptions(command, *arguments);
    command.option("--depfile", arguments->depfile, "Write the dependencies of the packs for Make and Ninja")
        .writes({".d", ".dep", ".deps", ".mk", ".make"})
        .valueName("FILE");
    command.addReportFlag();
    command["--watch"].excludes(command["--json"]);
    addThreadsOption(command, arguments->threads);
    return {command, [arguments](VerbReport& report, const CliContext& context) {
                return arguments->isWatching ? watch(*arguments, report, context)
                                             : exportAssets(*arguments, report, context);
            }};
}

}  // namespace rubble
