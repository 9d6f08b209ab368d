#include "app/cli/CommonOptions.h"
#include "app/cli/FragmentsText.h"
#include "app/cli/ProgressLine.h"
#include "app/cli/Verb.h"
#include "core/asset/Bake.h"
#include "core/base/Parallel.h"
#include "core/io/AtomicFile.h"
#include "core/io/ExportFolder.h"
#include "core/io/PackFile.h"
#include "core/io/ProjectFile.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <mutex>

namespace rubble {
namespace {

constexpr const char* kFooter =
    R"(A project: every value in its range; then every asset is broken as for an export, and every stage of it verified:
triangulation, cells, fragments, hulls, meshes. A pack: the folder that export wrote, or its pack.json; every file is
compared with the manifest, too.

Examples:
  rubble-cli check house.rubble
  rubble-cli check packs/wall)";

struct CheckArguments {
    std::string path;
    int threads = 1;
};

/// What the check of one asset found.
struct Finding {
    Status status = success();
    std::string summary;
};

std::string soundText(const std::string& name, std::size_t fragments, double volume) {
    return name + ": " + fragmentsText(fragments, volume) + ", sound\n";
}

Finding findingOn(const Asset& asset, const TaskContext& task) {
    const Result<Bake> baked = bake(asset, task);
    if (!baked) return {baked.error(), {}};
    for (const auto verify : {verifyBake, verifyMeshes}) {
        if (task.isCancelled()) return {TaskContext::cancelled(), {}};
        if (const auto fault = verify(*baked, asset)) return {Error{ErrorCode::BadInput, *fault}, {}};
    }
    return {success(), soundText(asset.name, baked->fragmentCount(), baked->whole.volume)};
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

Status checkProject(const CheckArguments& arguments, const CliContext& context) {
    const Result<Project> project = loadProject(arguments.path);
    if (!project) return project.error();
    ProgressLine line(context, "Checking");
    std::mutex guard;  // of the line and of what is done
    std::size_t done = 0;
    const std::vector<Asset>& assets = project->assets;
    std::vector<Finding> findings(assets.size());
    forEachIndex(assets.size(), arguments.threads, [&](std::size_t index) {
        findings[index] = findingOn(assets[index], {.cancel = context.cancel});
        const std::lock_guard lock(guard);
        line.show(static_cast<double>(++done) / static_cast<double>(assets.size()));
    });
    line.clear();
    return told(findings, context);
}

/// What pack.json tells, and then that every file beside it is as it was exported.
Status checkPack(const std::filesystem::path& folder, const CliContext& context) {
    const std::filesystem::path path = folder / kPackName;
    const Result<std::string> json = readFile(path);
    if (!json) return json.error();
    const Result<Pack> pack = readPack(*json);
    if (!pack) return Error{pack.error().code, path.string() + ": " + pack.error().message};
    if (const auto fault = verifyPack(*pack)) return Error{ErrorCode::BadInput, path.string() + ": " + *fault};
    if (const auto fault = verifyExportFolder(folder)) return Error{ErrorCode::BadInput, *fault};
    return writeOutput("-", soundText(pack->name, pack->fragments.size(), pack->whole.volume), context);
}

Status check(const CheckArguments& arguments, const CliContext& context) {
    std::error_code ignored;  // what is not there is told by reading it
    const std::filesystem::path path = arguments.path;
    if (std::filesystem::is_directory(path, ignored)) return checkPack(path, context);
    if (path.filename() == kPackName) return checkPack(path.has_parent_path() ? path.parent_path() : ".", context);
    return checkProject(arguments, context);
}

}  // namespace

Verb addCheck(CLI::App& program) {
    CLI::App* command = program.add_subcommand("check", "Verify a project or an exported pack");
    const auto arguments = std::make_shared<CheckArguments>();
    command->footer(kFooter);
    command->add_option("PATH", arguments->path, "A project, a pack's folder, or its pack.json")
        ->required()
        ->type_name("");
    addThreadsOption(*command, arguments->threads);
    return {command, [arguments](const CliContext& context) { return check(*arguments, context); }};
}

}  // namespace rubble
