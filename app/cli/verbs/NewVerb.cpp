#include "app/cli/options/MaterialOptions.h"
#include "app/cli/verbs/Verb.h"
#include "core/asset/library/StarterProject.h"
#include "core/base/MessageText.h"
#include "core/io/json/JsonWriter.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/project/ProjectIdentity.h"
#include "core/io/project/ProjectLock.h"

#include <filesystem>
#include <memory>

namespace rubble {
namespace {

constexpr const char* kNewFooter =
    R"(Creates a project with a material and a wall of 1 x 1 x 0.5 m with 20 seeds, ready to draw, export or edit; with
--empty it has only the material. An existing file is not overwritten. With --material, the wall has that
material, its typical pattern and a threshold derived from its strength; see rubble-cli materials.

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
    const Result<MaterialLibrary> library = openMaterialLibrary(options.materials);
    if (!library) return library.error();
    const Result<LibraryMaterial> material = requireMaterial(*library, options.material);
    if (!material) return material.error();
    return options.isEmpty ? emptyProject(material->preset) : starterProject(material->preset);
}

Status createProject(const NewOptions& options, VerbReport& report, const CliContext& context) {
    Result<Project> project = projectFor(options);
    if (!project) return project.error();
    project->identity = newIdentity();
    const Result<std::shared_ptr<const LockFile>> lock = waitForProjectLock(options.file, context.cancel);
    if (!lock) return lock.error();
    std::error_code ignored;  // saving will report the error
    if (std::filesystem::exists(std::filesystem::symlink_status(options.file, ignored))) {
        return Error{ErrorCode::BadInput,
                     quotedPath(options.file) + " already exists; choose another name or delete it."};
    }
    if (const Status saved = saveProject(options.file, *project); !saved) return saved;
    report.writeResults = [file = options.file](JsonWriter& json) { json.text("project", printableText(file)); };
    return printSummary("Created " + options.file + ".\n", report, context);
}

}  // namespace

Verb addNew(CLI::App& program) {
    Command command(program, "new", "Create a project with a wall to start from", kNewFooter);
    const auto options = std::make_shared<NewOptions>();
    command.argument("FILE", options->file, "The project to create: wall.rubble").required();
    command.flag("--empty", options->isEmpty, "Omit the wall");
    const CommandOption material =
        command.option("--material", options->material, "The material of the wall").valueName("NAME");
    addMaterialsOption(command, options->materials);
    command["--materials"].needs(material);
    command.addReportFlag();
    return {command, [options](VerbReport& report, const CliContext& context) {
                return createProject(*options, report, context);
            }};
}

}  // namespace rubble
