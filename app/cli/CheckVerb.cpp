#include "app/cli/CommonOptions.h"
#include "app/cli/FragmentsText.h"
#include "app/cli/ProgressLine.h"
#include "app/cli/Verb.h"
#include "core/asset/Bake.h"
#include "core/asset/Problems.h"
#include "core/asset/Variants.h"
#include "core/base/Parallel.h"
#include "core/io/AtomicFile.h"
#include "core/io/ExportFolder.h"
#include "core/io/PackFile.h"
#include "core/io/ProjectFile.h"
#include "core/play/InstanceOverlaps.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <mutex>

namespace rubble {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFooter =
    R"(A project: every value in its range; then every asset is broken as for an export, and every stage of it verified:
triangulation, cells, fragments, hulls, meshes, in all variants that instances use. What an artist should look at, as the
editor's dock Problems lists it (slivers, tiny pieces, equal seeds, …), and instances that overlap are told and are no
fault. A pack: the folder that export wrote, or its pack.json; every file is compared with the manifest, too. A folder of
packs: each of them.

Examples:
  rubble-cli check house.rubble
  rubble-cli check packs
  rubble-cli check packs/wall packs/roof)";

struct CheckArguments {
    std::vector<std::string> paths;
    int threads = 1;
};

/// What the check of one asset or pack found.
struct Finding {
    Status status = success();
    std::string summary;
    std::string notices;  // a line each
};

std::string soundText(const std::string& name, std::size_t fragments, double volume) {
    return name + ": " + fragmentsText(fragments, volume) + ", sound\n";
}

Finding findingOn(const Asset& asset, const TaskContext& task) {
    const Result<Bake> baked = bake(asset, task);
    if (!baked) return {.status = baked.error()};
    for (const auto verify : {verifyBake, verifyMeshes}) {
        if (task.isCancelled()) return {.status = TaskContext::cancelled()};
        if (const auto fault = verify(*baked, asset)) return {.status = Error{ErrorCode::BadInput, *fault}};
    }
    std::string notices;
    for (const Problem& problem : problemsOf(asset, *baked)) notices += asset.name + ": " + problem.message + '\n';
    return {success(), soundText(asset.name, baked->fragmentCount(), baked->whole.volume), std::move(notices)};
}

/// Prints what is sound; a fault that tells of all that is not.
Status told(const std::vector<Finding>& findings, const CliContext& context) {
    std::string summary;
    std::string faults;
    for (const Finding& finding : findings) {
        if (!finding.status && finding.status.error().code == ErrorCode::Cancelled) return finding.status;
        summary += finding.summary;
        if (!finding.status) faults += (faults.empty() ? "" : "\n") + finding.status.error().message;
    }
    if (const Status written = writeOutput("-", summary, context); !written) return written;
    if (!faults.empty()) return Error{ErrorCode::BadInput, faults};
    return success();
}

void checkProject(const std::string& path, int threads, const CliContext& context, std::vector<Finding>& all) {
    const Result<Project> project = loadProject(path);
    if (!project) return all.push_back({.status = project.error()});
    ProgressLine line(context, "Checking");
    std::mutex guard;  // of the line and of what is done
    std::size_t done = 0;
    const std::vector<AssetVariant> variants = usedVariants(*project);
    std::vector<Finding> findings(variants.size());
    forEachIndex(variants.size(), threads, [&](std::size_t index) {
        const auto [asset, variant] = variants[index];
        findings[index] = findingOn(variantOf(*findAsset(*project, asset), variant), {.cancel = context.cancel});
        const std::lock_guard lock(guard);
        line.show(static_cast<double>(++done) / static_cast<double>(variants.size()));
    });
    line.clear();
    for (const Finding& finding : findings) context.err << finding.notices;
    std::ranges::move(findings, std::back_inserter(all));
    for (const Asset& asset : project->assets) {  // once, whatever its variants
        for (const Problem& problem : strengthProblems(asset, *findMaterial(*project, asset.material))) {
            context.err << asset.name << ": " << problem.message << '\n';
        }
    }
    for (const InstanceOverlap& overlap : instanceOverlaps(*project)) {
        context.err << path << ": " << sentenceOf(overlap, *project) << '\n';
    }
}

/// What pack.json tells, and then that every file beside it is as it was exported.
Finding findingOnPack(const fs::path& folder) {
    const fs::path path = folder / kPackName;
    const auto fault = [&](ErrorCode code, const std::string& sentence) {
        return Finding{.status = Error{code, path.string() + ": " + sentence}};
    };
    const Result<std::string> json = readFile(path);
    if (!json) return {.status = json.error()};
    const Result<Pack> pack = readPack(*json);
    if (!pack) return fault(pack.error().code, pack.error().message);
    if (const auto wrong = verifyPack(*pack)) return fault(ErrorCode::BadInput, *wrong);
    if (const auto wrong = verifyExportFolder(folder)) return {.status = Error{ErrorCode::BadInput, *wrong}};
    return {.summary = soundText(pack->name, pack->fragments.size(), pack->whole.volume)};
}

/// True for the folder of a pack, even where one of its two lists has been lost.
bool isPack(const fs::path& folder) {
    std::error_code ignored;
    return fs::exists(folder / kPackName, ignored) || fs::exists(folder / kManifestName, ignored);
}

/// The folders of packs that a folder stands for, by name: itself, or those in it.
Result<std::vector<fs::path>> packsOf(const fs::path& folder) {
    if (isPack(folder)) return std::vector{folder};
    std::vector<fs::path> packs;
    std::error_code fault;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder, fault)) {
        if (isPack(entry.path())) packs.push_back(entry.path());
    }
    const std::string name = '"' + folder.string() + '"';
    if (fault) return Error{ErrorCode::Io, "Cannot read " + name + ": " + fault.message() + "."};
    if (packs.empty())
        return Error{ErrorCode::NotFound, name + " is no pack and holds none: there is no " + kPackName + " in it."};
    std::ranges::sort(packs);
    return packs;
}

void checkPath(const std::string& given, int threads, const CliContext& context, std::vector<Finding>& all) {
    std::error_code ignored;  // what is not there is told by reading it
    const fs::path path = given;
    if (path.filename() == kPackName)
        return all.push_back(findingOnPack(path.has_parent_path() ? path.parent_path() : "."));
    if (!fs::is_directory(path, ignored)) return checkProject(given, threads, context, all);
    const Result<std::vector<fs::path>> packs = packsOf(path);
    if (!packs) return all.push_back({packs.error(), {}});
    std::vector<Finding> findings(packs->size());
    forEachIndex(packs->size(), threads, [&](std::size_t index) {
        const bool isCancelled = context.cancel.isCancelled();
        findings[index] = isCancelled ? Finding{.status = TaskContext::cancelled()} : findingOnPack((*packs)[index]);
    });
    std::ranges::move(findings, std::back_inserter(all));
}

Status check(const CheckArguments& arguments, const CliContext& context) {
    std::vector<Finding> findings;
    for (const std::string& path : arguments.paths) checkPath(path, arguments.threads, context, findings);
    return told(findings, context);
}

}  // namespace

Verb addCheck(CLI::App& program) {
    CLI::App* command = program.add_subcommand("check", "Verify projects and exported packs");
    const auto arguments = std::make_shared<CheckArguments>();
    command->footer(kFooter);
    command->add_option("PATH", arguments->paths, "A project, a pack's folder or its pack.json, or a folder of packs")
        ->required()
        ->type_name("");
    addThreadsOption(*command, arguments->threads);
    return {command, [arguments](const CliContext& context) { return check(*arguments, context); }};
}

}  // namespace rubble
