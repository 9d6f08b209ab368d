#include "app/cli/CommonOptions.h"
#include "app/cli/ImportSummary.h"
#include "app/cli/Verb.h"
#include "core/asset/AssetImport.h"
#include "core/io/MeshImport.h"
#include "core/io/ProjectFile.h"

#include <CLI/CLI.hpp>

#include <memory>
#include <optional>
#include <ostream>

namespace rubble {
namespace {

constexpr const char* kFooter =
    R"(Reads OBJ, glTF, GLB, FBX, STL and PLY, in a process of its own that may take 1 GiB and 10 s. Each object that is a
prism - two parallel caps with the same outline along any axis, sides square to them - becomes an asset, and an
instance that stands where the mesh stood. What was found, and what was merged or left out, goes to standard output.
An object that is refused keeps no others from being imported; why goes to standard error. Where all are, nothing is
written.

Without --into, a new project is made beside FILE (wall.glb: wall.rubble); one that is there is not touched.
glTF is in metres, FBX says its unit; OBJ, STL and PLY do not, and are taken to be in metres.
An object that is a prism along several axes, such as a box, is extruded along the one in which it is thinnest.
With --asset an asset that is there is imported again: it takes the new outline, depth and look, and keeps its
material, pattern, levels, threshold and instances.

Examples:
  rubble-cli import wall.glb
  rubble-cli import parts.stl --into house.rubble --unit mm --up z
  rubble-cli import wall2.glb --into house.rubble --asset Wall
  rubble-cli import boulder.ply --fallback silhouette --axis y)";

struct ImportVerbOptions {
    std::filesystem::path mesh;
    std::filesystem::path project;
    std::optional<double> metresPerUnit;
    std::string up = "y";
    std::string axis;
    std::string asset;
    std::string fallback;
};

/// The project to import into and where it is to be written; a new one where there is none yet.
struct Target {
    std::filesystem::path path;
    Project project;
};

Result<Target> targetOf(const ImportVerbOptions& options) {
    const bool isNamed = !options.project.empty();
    Target target{.path = isNamed ? options.project : std::filesystem::path(options.mesh).replace_extension(".rubble")};
    std::error_code ignored;
    if (!std::filesystem::exists(target.path, ignored)) return target;
    if (!isNamed)
        return Error{ErrorCode::BadInput,
                     "\"" + target.path.string() + "\" is there already; give --into to import into it or elsewhere."};
    Result<Project> project = loadProject(target.path);
    if (!project) return project.error();
    target.project = std::move(*project);
    return target;
}

ImportOptions importOptions(const ImportVerbOptions& given) {
    ImportOptions options{.metresPerUnit = given.metresPerUnit, .asset = given.asset};
    if (given.up == "z") options.up = UpAxis::Z;
    if (given.axis == "x") options.axis = AxisChoice::X;
    if (given.axis == "y") options.axis = AxisChoice::Y;
    if (given.axis == "z") options.axis = AxisChoice::Z;
    if (given.fallback == "silhouette") options.fallback = PrismFallback::Silhouette;
    if (given.fallback == "cap") options.fallback = PrismFallback::TopCap;
    return options;
}

/// Why objects were refused, a line each; where one is no prism, with what can be done.
std::string refusals(const ImportOutcome& outcome, const ImportVerbOptions& options) {
    std::string text;
    for (const Error& error : outcome.refused) {
        std::string sentence = error.message;
        if (error.code == ErrorCode::Degenerate && options.fallback.empty()) {
            if (sentence.ends_with('.')) sentence.pop_back();
            sentence += "; --fallback silhouette or --fallback cap takes its outline instead.";
        }
        text += (text.empty() ? "" : "\n") + sentence;
    }
    return text;
}

/// A project in place of a mesh file is a slip of the hand.
Status checkIsNoProject(const std::filesystem::path& mesh) {
    if (mesh.extension() != ".rubble") return success();
    const std::string name = mesh.string();
    return Error{ErrorCode::BadInput,
                 "\"" + name + "\" is a project, not a mesh file: give a mesh to import, and --into " + name +
                     " to put it there; to write meshes of the project, see rubble-cli export."};
}

Status import(const ImportVerbOptions& options, const CliContext& context) {
    const TaskContext task{.cancel = context.cancel};
    if (const Status isMesh = checkIsNoProject(options.mesh); !isMesh) return isMesh;
    Result<Target> target = targetOf(options);
    if (!target) return target.error();
    const Result<SourceScene> scene = importMesh(options.mesh, importerBeside(context.programFolder), task);
    if (!scene) return scene.error();
    const Result<ImportOutcome> outcome =
        importedInto(std::move(target->project), *scene, options.mesh.stem().string(), importOptions(options), task);
    if (!outcome) return outcome.error();
    const std::string refused = refusals(*outcome, options);
    if (outcome->assets.empty()) return Error{ErrorCode::BadInput, refused};
    if (!refused.empty()) context.err << refused << '\n';
    if (const Status saved = saveProject(target->path, outcome->project); !saved) return saved.error();
    return writeOutput("-", importSummary(*outcome, target->path.string()), context);
}

}  // namespace

Verb addImport(CLI::App& program) {
    CLI::App* command = program.add_subcommand("import", "Turn the objects of a mesh file into assets");
    const auto options = std::make_shared<ImportVerbOptions>();
    command->footer(kFooter);
    command->add_option("FILE", options->mesh, "The mesh file")->required()->type_name("");
    command->add_option("--into", options->project, "The project to import into; made where there is none")
        ->option_text("PROJECT");
    addUnitOption(*command, options->metresPerUnit);
    command->add_option("--up", options->up, "Which axis of the file is up: y if not given")
        ->check(oneOf({"y", "z"}))
        ->option_text("y|z");
    command->add_option("--axis", options->axis, "Extrude along the axis nearest to this one (y is up)")
        ->check(oneOf({"x", "y", "z"}))
        ->option_text("x|y|z");
    command->add_option("--asset", options->asset, "Import again into this asset, or make it")->option_text("NAME");
    command->add_option("--fallback", options->fallback, "What to take of an object that is no prism, along --axis")
        ->check(oneOf({"silhouette", "cap"}))
        ->option_text("silhouette|cap");
    return {command, [options](const CliContext& context) { return import(*options, context); }};
}

}  // namespace rubble
