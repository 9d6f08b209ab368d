#pragma once

#include "app/cli/Cli.h"
#include "core/asset/Project.h"
#include "core/base/Result.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace rubble {

/// Which shots are fired at a project's scene: none where nothing is given.
struct ShotOptions {
    std::vector<std::string> names;  // of the project's own
    std::string file;                // with further ones
};

/// Adds --shot, which may be given several times, and --shots to a verb.
void addShotOptions(CLI::App& command, ShotOptions& options);

/// The shots that are meant, those of the project first, in its order.
///
/// Errors: NotFound, naming the first name that no shot has and the names that there are; those of readInput() and of
/// readShotList(), with the file's name.
Result<std::vector<Shot>> chosenShots(const Project& project, const ShotOptions& options, const CliContext& context);

}  // namespace rubble
