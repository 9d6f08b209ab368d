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

Examples:
  rubble-cli new wall.rubble
  rubble-cli new crates.rubble --empty)";

struct NewOptions {
    std::string file;
    bool isEmpty = false;
};

Status makeNew(const NewOptions& options, const CliContext& context) {
    std::error_code ignored;  // what cannot be looked at cannot be written either, and that is told
    if (std::filesystem::exists(std::filesystem::symlink_status(options.file, ignored))) {
        return Error{ErrorCode::BadInput,
                     "\"" + options.file + "\" is already there; choose another name or delete it."};
    }
    const Status saved = saveProject(options.file, options.isEmpty ? emptyProject() : starterProject());
    if (!saved) return saved;
    return writeOutput("-", "Wrote " + options.file + ".\n", context);
}

}  // namespace

Verb addNew(CLI::App& program) {
    CLI::App* command = program.add_subcommand("new", "Write a new project with one wall to start from");
    const auto options = std::make_shared<NewOptions>();
    command->footer(kFooter);
    command->add_option("FILE", options->file, "The project to write, as wall.rubble")->required()->type_name("");
    command->add_flag("--empty", options->isEmpty, "Without the wall");
    return {command, [options](const CliContext& context) { return makeNew(*options, context); }};
}

}  // namespace rubble
