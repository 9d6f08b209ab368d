#include "app/cli/console/InputOutput.h"
#include "app/cli/console/ProgressLine.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/output/FragmentsText.h"
#include "app/cli/output/PackFolders.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/bake/Bake.h"
#include "core/asset/checks/Problems.h"
#include "core/asset/checks/VerifyBake.h"
#include "core/asset/checks/VerifyMeshes.h"
#include "core/asset/project/Variants.h"
#include "core/base/MessageText.h"
#include "core/base/Parallel.h"
#include "core/base/QuantityText.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/output/ExportCheck.h"
#include "core/io/output/ExportIndex.h"
#include "core/io/pack/ImporterProblems.h"
#include "core/io/pack/PackBinary.h"
#include "core/io/pack/PackFile.h"
#include "core/io/pack/SceneFile.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "core/play/scene/InstanceOverlaps.h"
#include "core/play/scene/SupportProblems.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <span>

namespace rubble {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCheckFooter =
    R"(Checks a project: the range of every value; then fractures every asset, in all variants that instances use, and
verifies triangulation, cells, fragments, hulls and meshes. Warnings, which the editor lists in the dock
Problems (slivers, tiny fragments, duplicate seeds, ...), and overlapping instances are printed, too, but are
faults only with --strict. Checks a pack, given by its folder or its pack.json, and compares every file with the
manifest; or all packs in a folder, or beside a scene.json, and that the scene is of the same export. Exits with 3 if
it found faults, and with 1 if something cannot be read as a project or a pack.

Examples:
  rubble-cli check house.rubble
  rubble-cli check house.rubble --strict --json
  rubble-cli check packs
  rubble-cli check packs/wall packs/roof)";

struct CheckArguments {
    std::vector<std::string> paths;
    bool isStrict = false;
    int threads = 1;
};

/// An asset, or a pack, without faults.
struct CheckedItem {
    const char* kind;
    std::string file;  // the project, or the folder of the pack
    std::string asset;
    std::size_t fragments = 0;
    double volume = 0.0;  // m³
};

/// The result of checking an asset or a pack.
struct CheckResult {
    Status status = success();  // an error if it could not be checked
    std::string file;           // then
    std::optional<Finding> fault;
    std::vector<Finding> warnings;  // and notes
    std::optional<CheckedItem> item;
    std::shared_ptr<const Bake> bake;  // if it is kept
    std::string physicsHash;           // of a pack
};

CheckResult cannotCheck(const Error& error, std::string file) { return {.status = error, .file = std::move(file)}; }

CheckResult faulty(const char* code, FindingPlace place, const std::string& message) {
    return {.fault = Finding{Severity::Error, code, std::move(place), message}};
}

/// Whether the bake of an asset without faults is needed afterwards.
enum class KeepBake { No, Yes };

CheckResult checkAsset(const std::string& file, const Asset& asset, KeepBake keep, const TaskContext& task) {
    const FindingPlace place{.file = file, .asset = asset.name};
    Result<Bake> baked = bake(asset, task);
    if (!baked) {
        const bool isChecked = baked.error().code != ErrorCode::Cancelled && baked.error().code != ErrorCode::Limit;
        if (!isChecked) return cannotCheck(baked.error(), file);
        return {.fault = findingOf(baked.error(), place)};
    }
    if (const auto found = verifyBake(*baked, asset)) return faulty("InvalidBake", place, *found);
    if (baked->fragmentCount() == 0 && asset.shaping.gap > 0.0) {
        return faulty("NoFragments", place,
                      shownName(asset.name) + ": The gap between fragments leaves none of them; make it narrower.");
    }
    if (task.isCancelled()) return cannotCheck(TaskContext::cancelled(), file);
    if (const auto found = verifyMeshes(*baked, asset)) return faulty("InvalidMesh", place, *found);
    CheckResult result{.item = CheckedItem{"asset", file, asset.name, baked->fragmentCount(), baked->whole.volume}};
    for (const Diagnostic& problem : problemsOf(asset, *baked))
        result.warnings.push_back(findingOf(problem, file, asset.name));
    if (keep == KeepBake::Yes) result.bake = std::make_shared<const Bake>(std::move(*baked));
    return result;
}

std::string okText(const CheckedItem& item) {
    return shownName(item.asset) + ": " + fragmentsText(item.fragments, item.volume) + ", ok\n";
}

void writeItems(JsonWriter& json, const std::vector<CheckedItem>& items) {
    json.openArray("checked");
    for (const CheckedItem& item : items) {
        json.openObject({}, JsonLayout::Inline);
        json.text("kind", item.kind);
        json.text("file", printableText(item.file));
        json.text("asset", printableText(item.asset));
        json.wholeNumber("fragments", std::uint64_t{item.fragments});
        json.number("volume", item.volume);
        json.close();
    }
    json.close();
}

/// Prints the results without faults and reports the faults. If something could not be checked, returns an error with
/// a line for each fault and each of these.
Status reportResults(const std::vector<CheckResult>& results, VerbReport& report, const CliContext& context) {
    std::string summary;
    std::vector<CheckedItem> items;
    bool isChecked = true;
    for (const CheckResult& result : results) {
        if (!result.status && result.status.error().code == ErrorCode::Cancelled) return result.status;
        if (result.item) {
            summary += okText(*result.item);
            items.push_back(*result.item);
        }
        if (!result.status) report.findings.push_back(findingOf(result.status.error(), {.file = result.file}));
        if (result.fault) report.findings.push_back(*result.fault);
        if (!result.status || result.fault) conclude(report, report.findings.back().message);
        isChecked = isChecked && result.status;
    }
    report.writeResults = [items = std::move(items)](JsonWriter& json) { writeItems(json, items); };
    if (const Status written = printSummary(summary, report, context); !written) return written;
    if (isChecked) return success();
    report.hasErrorInFindings = true;
    return Error{ErrorCode::BadInput, report.conclusion};
}

/// Adds a warning or a note to the findings and prints it; strictly, a warning is a fault.
void warn(const Finding& finding, bool isStrict, VerbReport& report, const CliContext& context) {
    const std::string owner = finding.place.asset.empty() ? finding.place.file : shownName(finding.place.asset);
    const std::string line = owner + ": " + finding.message;
    report.findings.push_back(finding);
    if (isStrict && finding.severity == Severity::Warning) return conclude(report, line);
    context.err << line << '\n';
}

/// Checks all assets in all variants that instances use.
std::vector<CheckResult> checkAssets(const std::string& file, const Project& project, int threads,
                                     const CliContext& context) {
    ProgressLine line(context, "Checking");
    std::mutex guard;  // guards line and done
    std::size_t done = 0;
    const std::vector<AssetVariant> variants = usedVariants(project);
    std::vector<CheckResult> results(variants.size());
    const KeepBake keep = mayHaveSceneProblems(project) ? KeepBake::Yes : KeepBake::No;
    forEachIndex(variants.size(), threads, [&](std::size_t index) {
        const auto [asset, variant] = variants[index];
        results[index] =
            checkAsset(file, variantOf(*findAsset(project, asset), variant), keep, {.cancel = context.cancel});
        const std::lock_guard lock(guard);
        line.show(static_cast<double>(++done) / static_cast<double>(variants.size()));
    });
    line.clear();
    return results;
}

/// Warnings of what only the scene of a project shows.
std::vector<Finding> sceneWarnings(const std::string& file, const Project& project,
                                   const std::vector<CheckResult>& results, const TaskContext& task) {
    AssetBakes bakes;
    const std::vector<AssetVariant> variants = usedVariants(project);
    for (std::size_t k = 0; k < variants.size(); ++k) {
        if (results[k].bake == nullptr) return {};
        bakes[variants[k]] = results[k].bake;
    }
    std::vector<Finding> warnings;
    for (const Diagnostic& problem : sceneProblems(project, bakes, task)) {
        const Asset* asset = findAsset(project, problem.place.asset);
        warnings.push_back(findingOf(problem, file, asset != nullptr ? asset->name : std::string()));
    }
    return warnings;
}

/// Warnings of what other programs do with the names in the exports of a project.
std::vector<Finding> importerWarnings(const std::string& file, const Project& project) {
    std::vector<Finding> warnings;
    std::vector<Id> assets;
    for (const Asset& asset : project.assets) {
        assets.push_back(asset.id);
        for (const Diagnostic& problem : surfaceNameProblems(packSurfaces(asset, materialsOf(project, asset))))
            warnings.push_back(findingOf(problem, file, asset.name));
    }
    for (const PackListing& pack : packListings(project, assets, {})) {
        for (const Diagnostic& problem : nameLengthProblems(pack))
            warnings.push_back(findingOf(problem, file, pack.folder));
    }
    return warnings;
}

std::vector<Finding> overlapWarnings(const std::string& path, const Project& project) {
    std::vector<Finding> warnings;
    for (OverlapNote& note : overlapNotes(project))
        warnings.push_back({Severity::Warning, "OverlappingInstances", {.file = path}, std::move(note.sentence)});
    return warnings;
}

void checkProject(const std::string& path, const CheckArguments& arguments, VerbReport& report,
                  const CliContext& context, std::vector<CheckResult>& all) {
    const auto add = [&](const Finding& finding) { warn(finding, arguments.isStrict, report, context); };
    std::vector<Diagnostic> notes;
    const Result<Project> project = loadProject(path, &notes);
    if (!project) return all.push_back(cannotCheck(project.error(), path));
    for (const Diagnostic& note : notes) add(findingOf(note, path, findAsset(*project, note.place.asset)->name));
    std::vector<CheckResult> results = checkAssets(path, *project, arguments.threads, context);
    for (const CheckResult& result : results) {
        for (const Finding& warning : result.warnings) add(warning);
    }
    std::ranges::for_each(sceneWarnings(path, *project, results, {.cancel = context.cancel}), add);
    std::ranges::move(results, std::back_inserter(all));
    for (const Asset& asset : project->assets) {  // once for all variants
        for (const Diagnostic& problem : strengthProblems(asset, *findMaterial(*project, asset.material)))
            add(findingOf(problem, path, asset.name));
    }
    std::ranges::for_each(importerWarnings(path, *project), add);
    std::ranges::for_each(overlapWarnings(path, *project), add);
}

/// Returns what is wrong with pack.bin beside a pack.json, which follows from it; nothing if there is none.
std::optional<std::string> binaryFault(const fs::path& folder, const Pack& pack) {
    std::error_code ignored;
    if (!fs::exists(fs::symlink_status(folder / kPackBinaryName, ignored))) return std::nullopt;
    const Result<std::string> bytes = readFile(folder / kPackBinaryName, Links::Refused);
    if (!bytes) return bytes.error().message;
    if (const Result<Pack> read = readPackBinary(*bytes); !read) return read.error().message;
    const Result<std::string> expected = packBinary(pack);
    if (!expected) return expected.error().message;
    if (*expected == *bytes) return std::nullopt;
    return "pack.bin is not of this pack; export it again.";
}

/// Warnings of a pack, and notes.
std::vector<Finding> packWarnings(const Pack& pack, const FindingPlace& place) {
    std::vector<Finding> findings;
    for (const auto& problems : {hullCornerProblems(pack), surfaceNameProblems(pack.surfaces)}) {
        for (const Diagnostic& problem : problems) findings.push_back(findingOf(problem, place.file, place.asset));
    }
    return findings;
}

CheckResult checkedPack(const fs::path& folder, const Pack& pack, const FindingPlace& place) {
    return {.warnings = packWarnings(pack, place),
            .item = CheckedItem{"pack", folder.string(), pack.names.name, pack.fragments.size(), pack.whole.volume},
            .physicsHash = pack.physicsHash};
}

/// Verifies a folder with pack.bin only, as far as its numbers allow.
CheckResult checkBinaryPack(const fs::path& folder) {
    const fs::path path = folder / kPackBinaryName;
    const Result<std::string> bytes = readFile(path, Links::Refused);
    if (!bytes) return cannotCheck(bytes.error(), path.string());
    const Result<Pack> pack = readPackBinary(*bytes);
    if (!pack) return cannotCheck({pack.error().code, path.string() + ": " + pack.error().message}, path.string());
    const FindingPlace place{.file = path.string(), .asset = pack->names.name};
    if (const auto found = verifyExportFolder(folder)) return faulty("InvalidExport", place, *found);
    return checkedPack(folder, *pack, place);
}

/// Verifies pack.json, and that no file was modified after the export.
CheckResult checkPack(const fs::path& folder) {
    const fs::path path = folder / kPackName;
    std::error_code missing;
    if (!fs::exists(fs::symlink_status(path, missing)) &&
        fs::exists(fs::symlink_status(folder / kPackBinaryName, missing)))
        return checkBinaryPack(folder);
    FindingPlace place{.file = path.string()};
    const auto invalid = [&](const std::string& message) {
        return faulty("InvalidPack", place, path.string() + ": " + message);
    };
    const Result<std::string> json = readFile(path, Links::Refused);
    if (!json) return cannotCheck(json.error(), path.string());
    const Result<Pack> pack = readPack(*json);
    if (!pack) return cannotCheck({pack.error().code, path.string() + ": " + pack.error().message}, path.string());
    place.asset = pack->names.name;
    if (const auto found = verifyPack(*pack)) return invalid(*found);
    if (const auto found = verifyPackText(*json, *pack)) return invalid(*found);
    if (const auto found = binaryFault(folder, *pack)) return invalid(*found);
    for (const PackMeshFile& mesh : pack->meshes) {
        std::error_code ignored;
        if (fs::exists(fs::symlink_status(folder / mesh.name, ignored))) continue;
        return invalid("The mesh " + quotedName(mesh.name) + " is not in the folder.");
    }
    if (const auto found = verifyExportFolder(folder)) return faulty("InvalidExport", place, *found);
    return checkedPack(folder, *pack, place);
}

/// Verifies that a scene is of the packs beside it; nothing if there is none.
std::optional<CheckResult> checkScene(const fs::path& folder, std::span<const fs::path> packs,
                                      std::span<const CheckResult> results) {
    const fs::path path = folder / kSceneName;
    std::error_code missing;
    if (!fs::exists(fs::symlink_status(path, missing))) return std::nullopt;
    const Result<std::string> json = readFile(path, Links::Refused);
    if (!json) return cannotCheck(json.error(), path.string());
    PackPhysicsHashes present;
    for (std::size_t k = 0; k < packs.size(); ++k) {
        if (!results[k].status || results[k].fault) return std::nullopt;  // its fault is reported
        present[packs[k].filename().string()] = results[k].physicsHash;
    }
    const std::optional<std::string> fault = scenePacksFault(*json, present);
    if (!fault) return std::nullopt;
    return faulty("InvalidScene", {.file = path.string()}, path.string() + ": " + *fault);
}

/// A warning where the scene is not as it was written, by the index beside it.
std::optional<Finding> editedScene(const fs::path& folder) {
    const Result<std::optional<ExportIndex>> index = readExportIndex(folder);
    if (!index || !*index) return std::nullopt;
    const auto listed = std::ranges::find((*index)->files, kSceneName, &ManifestEntry::name);
    if (listed == (*index)->files.end()) return std::nullopt;
    const Result<ManifestEntry> now = manifestEntryOfFile(folder, kSceneName);
    if (!now || *now == *listed) return std::nullopt;
    const std::string path = (folder / kSceneName).string();
    return Finding{Severity::Warning, "EditedScene", {.file = path}, path + ": It was changed after the export."};
}

void checkPath(const std::string& given, const CheckArguments& arguments, VerbReport& report, const CliContext& context,
               std::vector<CheckResult>& all) {
    std::error_code ignored;  // reading the path will report the error
    const fs::path path = given;
    const auto addResult = [&](CheckResult result) {
        for (const Finding& warning : result.warnings) warn(warning, arguments.isStrict, report, context);
        all.push_back(std::move(result));
    };
    if (path.filename() == kPackName && !fs::is_directory(path, ignored))
        return addResult(checkPack(path.has_parent_path() ? path.parent_path() : "."));
    const bool isScene = path.filename() == kSceneName && !fs::is_directory(path, ignored);
    if (!isScene && !fs::is_directory(path, ignored)) return checkProject(given, arguments, report, context, all);
    const fs::path folder = !isScene ? path : path.has_parent_path() ? path.parent_path() : fs::path(".");
    const Result<std::vector<fs::path>> packs = packsOf(folder);
    if (!packs) return all.push_back(cannotCheck(packs.error(), given));
    std::vector<CheckResult> results(packs->size());
    forEachIndex(packs->size(), arguments.threads, [&](std::size_t index) {
        const bool isCancelled = context.cancel.isCancelled();
        results[index] = isCancelled ? cannotCheck(TaskContext::cancelled(), given) : checkPack((*packs)[index]);
    });
    std::optional<CheckResult> scene = checkScene(folder, *packs, results);
    if (std::optional<Finding> edited = editedScene(folder); edited && !scene)
        results.front().warnings.push_back(std::move(*edited));
    for (CheckResult& result : results) addResult(std::move(result));
    if (scene) addResult(std::move(*scene));
}

Status check(const CheckArguments& arguments, VerbReport& report, const CliContext& context) {
    std::vector<CheckResult> results;
    for (const std::string& path : arguments.paths) checkPath(path, arguments, report, context, results);
    const auto warnings =
        static_cast<std::size_t>(std::ranges::count(report.findings, Severity::Warning, &Finding::severity));
    if (const Status reported = reportResults(results, report, context); !reported) return reported;
    if (arguments.isStrict && warnings > 0)
        conclude(report, countText(warnings, "warning", "warnings") + " found, which --strict does not allow.");
    return success();
}

}  // namespace

Verb addCheck(CLI::App& program) {
    Command command(program, "check", "Verify projects and exported packs", kCheckFooter);
    const auto arguments = std::make_shared<CheckArguments>();
    command
        .argument("PATH", arguments->paths, "A project, a pack's folder or pack.json, a folder of packs or its scene")
        .required();
    command.flag("--strict", arguments->isStrict, "Warnings are faults, too");
    command.addReportFlag();
    addThreadsOption(command, arguments->threads);
    return {command,
            [arguments](VerbReport& report, const CliContext& context) { return check(*arguments, report, context); }};
}

}  // namespace rubble
