#include "app/cli/console/InputOutput.h"
#include "app/cli/console/ProgressLine.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/output/FragmentsText.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/bake/Bake.h"
#include "core/asset/checks/Problems.h"
#include "core/asset/checks/VerifyBake.h"
#include "core/asset/checks/VerifyMeshes.h"
#include "core/asset/project/Variants.h"
#include "core/base/MessageText.h"
#include "core/base/Parallel.h"
#include "core/io/pack/ExportCheck.h"
#include "core/io/pack/ExportManifest.h"
#include "core/io/pack/PackBinary.h"
#include "core/io/pack/PackFile.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/system/AtomicFile.h"
#include "core/io/system/FolderReading.h"
#include "core/io/system/Temporary.h"
#include "core/play/scene/InstanceOverlaps.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <iterator>
#include <memory>
#include <mutex>

namespace rubble {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCheckFooter =
    R"(Checks a project: the range of every value; then fractures every asset, in all variants that instances use, and
verifies triangulation, cells, fragments, hulls and meshes. Warnings, which the editor lists in the dock
Problems (slivers, tiny fragments, duplicate seeds, ...), and overlapping instances are printed, too, but are
not errors. Checks a pack, given by its folder or its pack.json, and compares every file with the manifest; or all
packs in a folder.

Examples:
  rubble-cli check house.rubble
  rubble-cli check packs
  rubble-cli check packs/wall packs/roof)";

struct CheckArguments {
    std::vector<std::string> paths;
    int threads = 1;
};

/// The result of checking an asset or a pack.
struct CheckResult {
    Status status = success();
    std::string summary;
    std::string warnings;  // one per line
};

std::string okText(const std::string& name, std::size_t fragments, double volume) {
    return shownName(name) + ": " + fragmentsText(fragments, volume) + ", ok\n";
}

CheckResult checkAsset(const Asset& asset, const TaskContext& task) {
    const Result<Bake> baked = bake(asset, task);
    if (!baked) return {.status = baked.error()};
    for (const auto verify : {verifyBake, verifyMeshes}) {
        if (task.isCancelled()) return {.status = TaskContext::cancelled()};
        if (const auto found = verify(*baked, asset)) return {.status = Error{ErrorCode::BadInput, *found}};
    }
    std::string warnings;
    for (const Diagnostic& problem : problemsOf(asset, *baked))
        warnings += shownName(asset.name) + ": " + problem.message + '\n';
    return {success(), okText(asset.name, baked->fragmentCount(), baked->whole.volume), std::move(warnings)};
}

/// Prints the results without errors; returns an error with a line for each of the others.
Status printResults(const std::vector<CheckResult>& results, const CliContext& context) {
    std::string summary;
    std::string errors;
    for (const CheckResult& result : results) {
        if (!result.status && result.status.error().code == ErrorCode::Cancelled) return result.status;
        summary += result.summary;
        if (!result.status) errors += (errors.empty() ? "" : "\n") + result.status.error().message;
    }
    if (const Status written = printText(summary, context); !written) return written;
    if (!errors.empty()) return Error{ErrorCode::BadInput, errors};
    return success();
}

void checkProject(const std::string& path, int threads, const CliContext& context, std::vector<CheckResult>& all) {
    std::vector<Diagnostic> notes;
    const Result<Project> project = loadProject(path, &notes);
    if (!project) return all.push_back({.status = project.error()});
    for (const Diagnostic& note : notes)
        context.err << findAsset(*project, note.place.asset)->name << ": " << note.message << '\n';
    ProgressLine line(context, "Checking");
    std::mutex guard;  // guards line and done
    std::size_t done = 0;
    const std::vector<AssetVariant> variants = usedVariants(*project);
    std::vector<CheckResult> results(variants.size());
    forEachIndex(variants.size(), threads, [&](std::size_t index) {
        const auto [asset, variant] = variants[index];
        results[index] = checkAsset(variantOf(*findAsset(*project, asset), variant), {.cancel = context.cancel});
        const std::lock_guard lock(guard);
        line.show(static_cast<double>(++done) / static_cast<double>(variants.size()));
    });
    line.clear();
    for (const CheckResult& result : results) context.err << result.warnings;
    std::ranges::move(results, std::back_inserter(all));
    for (const Asset& asset : project->assets) {  // once for all variants
        for (const Diagnostic& problem : strengthProblems(asset, *findMaterial(*project, asset.material))) {
            context.err << asset.name << ": " << problem.message << '\n';
        }
    }
    for (const InstanceOverlap& overlap : instanceOverlaps(*project)) {
        context.err << path << ": " << sentenceOf(overlap, *project) << '\n';
    }
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

/// Verifies a folder with pack.bin only, as far as its numbers allow.
CheckResult checkBinaryPack(const fs::path& folder) {
    const fs::path path = folder / kPackBinaryName;
    const Result<std::string> bytes = readFile(path, Links::Refused);
    if (!bytes) return {.status = bytes.error()};
    const Result<Pack> pack = readPackBinary(*bytes);
    if (!pack) return {.status = Error{pack.error().code, path.string() + ": " + pack.error().message}};
    if (const auto found = verifyExportFolder(folder)) return {.status = Error{ErrorCode::BadInput, *found}};
    return {.summary = okText(pack->names.name, pack->fragments.size(), pack->whole.volume)};
}

/// Verifies pack.json, and that no file was modified after the export.
CheckResult checkPack(const fs::path& folder) {
    const fs::path path = folder / kPackName;
    std::error_code missing;
    if (!fs::exists(fs::symlink_status(path, missing)) &&
        fs::exists(fs::symlink_status(folder / kPackBinaryName, missing)))
        return checkBinaryPack(folder);
    const auto error = [&](ErrorCode code, const std::string& message) {
        return CheckResult{.status = Error{code, path.string() + ": " + message}};
    };
    const Result<std::string> json = readFile(path, Links::Refused);
    if (!json) return {.status = json.error()};
    const Result<Pack> pack = readPack(*json);
    if (!pack) return error(pack.error().code, pack.error().message);
    if (const auto found = verifyPack(*pack)) return error(ErrorCode::BadInput, *found);
    if (const auto found = verifyPackText(*json, *pack)) return error(ErrorCode::BadInput, *found);
    if (const auto found = binaryFault(folder, *pack)) return error(ErrorCode::BadInput, *found);
    for (const PackMeshFile& mesh : pack->meshes) {
        std::error_code ignored;
        if (fs::exists(fs::symlink_status(folder / mesh.name, ignored))) continue;
        return error(ErrorCode::BadInput, "The mesh " + quotedName(mesh.name) + " is not in the folder.");
    }
    if (const auto found = verifyExportFolder(folder)) return {.status = Error{ErrorCode::BadInput, *found}};
    return {.summary = okText(pack->names.name, pack->fragments.size(), pack->whole.volume)};
}

/// Returns whether a folder is a pack, even if pack.json or the manifest is missing. A folder of either name is that
/// of an asset.
bool isPack(const fs::path& folder) {
    return std::ranges::any_of(std::array{kPackName, kManifestName}, [&](const char* name) {
        std::error_code ignored;
        const fs::file_status status = fs::symlink_status(folder / name, ignored);
        return fs::exists(status) && !fs::is_directory(status);
    });
}

/// Returns the folder if it is a pack, or the packs in it, sorted by name. Those that are being written, or that killed
/// programs left, are none.
Result<std::vector<fs::path>> packsOf(const fs::path& folder) {
    if (isPack(folder)) return std::vector{folder};
    std::vector<fs::path> packs;
    const Result<std::vector<fs::directory_entry>> entries = entriesOf(folder);
    if (!entries) return entries.error();
    for (const fs::directory_entry& entry : *entries) {
        const bool isTemporary = isTemporaryName(entry.path().filename().string());
        if (!isTemporary && isPack(entry.path())) packs.push_back(entry.path());
    }
    const std::string name = quotedPath(folder);
    if (packs.empty())
        return Error{ErrorCode::NotFound, name + " is not a pack and contains none: it has no " + kPackName + "."};
    std::ranges::sort(packs);
    return packs;
}

void checkPath(const std::string& given, int threads, const CliContext& context, std::vector<CheckResult>& all) {
    std::error_code ignored;  // reading the path will report the error
    const fs::path path = given;
    if (path.filename() == kPackName && !fs::is_directory(path, ignored))
        return all.push_back(checkPack(path.has_parent_path() ? path.parent_path() : "."));
    if (!fs::is_directory(path, ignored)) return checkProject(given, threads, context, all);
    const Result<std::vector<fs::path>> packs = packsOf(path);
    if (!packs) return all.push_back({packs.error(), {}});
    std::vector<CheckResult> results(packs->size());
    forEachIndex(packs->size(), threads, [&](std::size_t index) {
        const bool isCancelled = context.cancel.isCancelled();
        results[index] = isCancelled ? CheckResult{.status = TaskContext::cancelled()} : checkPack((*packs)[index]);
    });
    std::ranges::move(results, std::back_inserter(all));
}

Status check(const CheckArguments& arguments, const CliContext& context) {
    std::vector<CheckResult> results;
    for (const std::string& path : arguments.paths) checkPath(path, arguments.threads, context, results);
    return printResults(results, context);
}

}  // namespace

Verb addCheck(CLI::App& program) {
    Command command(program, "check", "Verify projects and exported packs", kCheckFooter);
    const auto arguments = std::make_shared<CheckArguments>();
    command.argument("PATH", arguments->paths, "A project, a pack's folder or its pack.json, or a folder of packs")
        .required();
    addThreadsOption(command, arguments->threads);
    return {command, [arguments](const CliContext& context) { return check(*arguments, context); }};
}

}  // namespace rubble
