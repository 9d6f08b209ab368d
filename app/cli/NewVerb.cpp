#include "app/cli/MaterialOptions.h"
#include "app/cli/Verb.h"
#include "core/asset/StarterProject.h"
#include "core/io/ProjectFile.h"

#include <CLI/CLI.hpp>

#include <filesystem>
#include <memory>

namespace rubble {
namespace {

constexpr const char* kFooter =
    R"(The project has a material and a wall of 1 x 1 x 0.5 m with 20 seeds, ready to draw, export or edit; with --empty it has
the material only. A file that is already there is left as it is, and told.
With --material it is made of that material, broken in its usual pattern, and its threshold follows from the material's strength;
see rubble-cli materials.

Examples:
  rubble-cli new wall.rubble
  rubble-cli new crates.rubble --empty
  rubble-cli new pane.rubble --material glass)";

struct NewOptions {
    std::string file;
    bool isEmpty = false;
    std::string material;
    std::string materials;
};

Result<Project> projectFor(const NewOptions& options) {
    if (options.material.empty()) return options.isEmpty ? emptyProject() : starterProject();
    const Result<MaterialLibrary> library = chosenLibrary(options.materials);
    if (!library) return library.error();
    const Result<LibraryMaterial> material = chosenMaterial(*library, options.material);
    if (!material) return material.error();
    return options.isEmpty ? emptyProject(material->preset) : starterProject(material->preset);
}

Status makeNew(const NewOptions& options, const CliContext& context) {
    std::error_code ignored;  // what cannot be looked at cannot be written either, and that is told
    if (std::filesystem::exists(std::filesystem::symlink_status(options.file, ignored))) {
        return Error{ErrorCode::BadInput,
                     "\"" + options.file + "\" is already there; choose another name or delete it."};
    }
    const Result<Project> project = projectFor(options);
    if (!project) return project.error();
    if (const Status saved = saveProject(options.file, *project); !saved) return saved;
    return writeOutput("-", "Wrote " + options.file + ".\n", context);
}

}  // namespace

Verb addNew(CLI::App& program) {
    CLI::App* command = program.add_subcommand("new", "Write a new project with one wall to start from");
    const auto options = std::make_shared<NewOptions>();
    command->footer(kFooter);
    command->add_option("FILE", options->file, "The project to write, as wall.rubble")->required()->type_name("");
    command->add_flag("--empty", options->isEmpty, "Without the wall");
    CLI::Option* material = command->add_option("--material", options->material, "Of what the wall is made");
    material->type_name("NAME");
    addMaterialsOption(*command, options->materials);
    command->get_option("--materials")->needs(material);
    return {command, [options](const CliContext& context) { return makeNew(*options, context); }};
}

}  // namespace rubble
