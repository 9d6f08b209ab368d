#include "app/cli/ChosenAssets.h"
#include "app/cli/CommonOptions.h"
#include "app/cli/Verb.h"
#include "core/asset/VertexSeeds.h"
#include "core/io/MeshImport.h"
#include "core/io/ProjectFile.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace rubble {
namespace {

constexpr const char* kFooter =
    R"(Adds a layer of placed seeds to an asset, one at each point of the mesh. The mesh is read as by import and looked
at along one of its axes, with its origin at the prism's; --fit scales and moves it instead until it fills the
outline. Points beyond the outline, and those that stand behind others, are left out and told.

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
    Result<Project> project = loadProject(options.project);
    if (!project) return project.error();
    const Result<std::vector<Id>> chosen = chosenAssets(*project, {options.asset});
    if (!chosen) return chosen.error();
    const Result<SourceScene> mesh = importMesh(options.mesh, importerBeside(context.programFolder), task);
    if (!mesh) return mesh.error();
    VertexView view = options.view;
    if (options.along != "z") view.along = options.along == "x" ? FileAxis::X : FileAxis::Y;
    Asset& asset = *std::ranges::find(project->assets, chosen->front(), &Asset::id);
    Result<VertexSeeds> found = seedsAtVertices(*mesh, view, asset.prism.outline);
    if (!found) return found.error();
    const std::size_t count = found->seeds.seeds.size();
    const std::string told = found->report();
    const Id layer = project->nextId++;
    asset.pattern.layers.push_back({.id = layer, .randomSeed = layer, .parameters = std::move(found->seeds)});
    if (const Status saved = saveProject(options.project, *project); !saved) return saved.error();
    return writeOutput("-",
                       "\"" + asset.name + "\" has a new layer of " + std::to_string(count) +
                           (count == 1 ? " seed." : " seeds.") + (told.empty() ? "" : " " + told) +
                           "\nWritten: " + options.project.string() + "\n",
                       context);
}

}  // namespace

Verb addSeeds(CLI::App& program) {
    CLI::App* command = program.add_subcommand("seeds", "Put seeds where a mesh has points");
    const auto options = std::make_shared<SeedsOptions>();
    command->footer(kFooter);
    command->add_option("FILE", options->mesh, "The mesh file")->required()->type_name("");
    command->add_option("--into", options->project, "The project that has the asset")
        ->required()
        ->option_text("PROJECT");
    command->add_option("--asset", options->asset, "The asset")->required()->option_text("NAME");
    addUnitOption(*command, options->view.metresPerUnit);
    command->add_option("--along", options->along, "The axis of the file that is looked along: z if not given")
        ->check(oneOf({"x", "y", "z"}))
        ->option_text("x|y|z");
    command->add_flag("--fit", options->view.isFitted, "Scale and move the mesh until it fills the outline");
    return {command, [options](const CliContext& context) { return addSeeds(*options, context); }};
}

}  // namespace rubble
