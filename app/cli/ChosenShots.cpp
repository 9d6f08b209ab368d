#include "app/cli/ChosenShots.h"

#include "app/cli/CommonOptions.h"
#include "app/cli/Verb.h"
#include "core/io/ShotJson.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace rubble {

void addShotOptions(CLI::App& command, ShotOptions& options) {
    command.add_option("--shot", options.names, "Fire this shot of the project; may be given several times")
        ->expected(1)
        ->take_all()
        ->option_text("NAME");
    command.add_option("--shots", options.file, "Fire the shots of a file, too: a JSON list of shots as in projects")
        ->option_text("FILE");
}

Result<std::vector<Shot>> chosenShots(const Project& project, const ShotOptions& options, const CliContext& context) {
    for (const std::string& name : options.names) {
        if (std::ranges::find(project.shots, name, &Shot::name) != project.shots.end()) continue;
        return Error{ErrorCode::NotFound,
                     "The project has no shot \"" + name + "\"; " + quotedNamesOf(project.shots) + "."};
    }
    std::vector<Shot> shots;
    for (const Shot& shot : project.shots) {
        if (std::ranges::find(options.names, shot.name) != options.names.end()) shots.push_back(shot);
    }
    if (options.file.empty()) return shots;
    const Result<std::string> text = readInput(options.file, context);
    if (!text) return text.error();
    const Result<std::vector<Shot>> further = readShotList(*text);
    if (!further) return Error{further.error().code, options.file + ": " + further.error().message};
    shots.insert(shots.end(), further->begin(), further->end());
    return shots;
}

}  // namespace rubble
