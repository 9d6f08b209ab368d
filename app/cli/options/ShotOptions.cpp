#include "app/cli/options/ShotOptions.h"

#include "app/cli/console/InputOutput.h"
#include "app/cli/options/Command.h"
#include "app/cli/options/CommonOptions.h"
#include "core/base/MessageText.h"
#include "core/io/project/ShotJson.h"

#include <algorithm>

namespace rubble {

void addShotOptions(Command& command, ShotOptions& options) {
    command.option("--shot", options.names, "Fire this shot of the project; repeatable").repeatable().valueName("NAME");
    command.option("--shots", options.file, "Also fire the shots of a file: a JSON array of shots as in projects")
        .reads()
        .valueName("FILE");
}

Result<std::vector<Shot>> selectedShots(const Project& project, const ShotOptions& options, const CliContext& context) {
    for (const std::string& name : options.names) {
        if (std::ranges::find(project.shots, name, &Shot::name) != project.shots.end()) continue;
        return Error{ErrorCode::NotFound,
                     "The project has no shot " + quotedName(name) + "; " + quotedNamesOf(project.shots) + "."};
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
