#include "app/cli/console/InputOutput.h"
#include "app/cli/options/AssetOptions.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/output/ProjectLoading.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/import/VertexSeeds.h"
#include "core/asset/project/Ids.h"
#include "core/base/MessageText.h"
#include "core/base/QuantityText.h"
#include "core/io/mesh/MeshImport.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/project/ProjectLock.h"

#include <algorithm>
#include <memory>

namespace rubble {
namespace {

constexpr const char* kSeedsFooter =
    R"(Adds a layer of placed seeds to an asset, one at each vertex of the mesh. The mesh is read as by rubble-cli
import and projected along one of its axes, with its origin at the prism's; --fit scales and moves it to fill
the outline instead. Vertices outside the outline and duplicates are ignored, and their number is printed.

Examples:
  rubble-cli seeds cracks.obj --into house.rubble --asset Wall
  rubble-cli seeds scan.ply --into house.rubble --asset Wall --along y --fit)";

struct SeedsOptions {
    std::filesystem::path mesh;
    std::filesystem::path project;
    std::string asset;
    std::string along = "z";
    VertexView view;
};

Status addSeeds(const SeedsOptions& options, const CliContext& context) {
    const TaskContext task{.cancel = context.cancel};
    const Result<SourceScene> mesh = importMesh(options.mesh, importerPath(context.programFolder), task);
    if (!mesh) return mesh.error();
    const Result<std::shared_ptr<const LockFile>> lock = waitForProjectLock(options.project, context.cancel);
    if (!lock) return lock.error();
    Result<Project> project = openProject(options.project, context);
    if (!project) return project.error();
    const Result<std::vector<Id>> selected = selectedAssets(*project, {options.asset});
    if (!selected) return selected.error();
    VertexView view = options.view;
    if (options.along != "z") view.along = options.along == "x" ? FileAxis::X : FileAxis::Y;
    Asset& asset = *std::ranges::find(project->assets, selected->front(), &Asset::id);
    Result<VertexSeeds> found = seedsAtVertices(*mesh, view, asset.prism.outline);
    if (!found) return found.error();
    const std::size_t count = found->seeds.seeds.size();
    const std::string omissions = found->omissionText();
    const Id layer = allocateId(*project);
    asset.pattern.layers.push_back({.id = layer, .randomSeed = layer, .parameters = std::move(found->seeds)});
    if (const Status saved = saveProject(options.project, *project); !saved) return saved.error();
    return printText(quotedName(asset.name) + " has a new layer of " + countText(count, "seed", "seeds") + "." +
                         (omissions.empty() ? "" : " " + omissions) + "\nSaved " + options.project.string() + "\n",
                     context);
}

}  // namespace

Verb addSeeds(CLI::App& program) {
    Command command(program, "seeds", "Place seeds at the vertices of a mesh", kSeedsFooter);
    const auto options = std::make_shared<SeedsOptions>();
    command.argument("FILE", options->mesh, "The mesh file").required();
    command.option("-i,--into", options->project, "The project of the asset").required().valueName("PROJECT");
    command.option("-a,--asset", options->asset, "The asset").required().valueName("NAME");
    addUnitOption(command, options->view.metresPerUnit);
    command.option("--along", options->along, "The axis of the file to project along (default: z)")
        .oneOf({"x", "y", "z"})
        .valueName("x|y|z");
    command.flag("--fit", options->view.isFitted, "Scale and move the mesh to fill the outline");
    return {command, [options](const CliContext& context) { return addSeeds(*options, context); }};
}

}  // namespace rubble
