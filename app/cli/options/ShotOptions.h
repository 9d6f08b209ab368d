#pragma once

#include "app/cli/console/CliContext.h"
#include "core/asset/project/Project.h"
#include "core/base/Result.h"

#include <string>
#include <vector>

namespace rubble {

class Command;

/// The shots to fire at a project's scene; none by default.
struct ShotOptions {
    std::vector<std::string> names;  // of shots of the project
    std::string file;                // with further shots; empty: none
};

/// Adds --shot, which is repeatable, and --shots to a verb.
void addShotOptions(Command& command, ShotOptions& options);

/// Returns the selected shots, those of the project first, in its order.
///
/// Errors: NotFound, with the first unknown name and the names of all shots; those of readInput() and of
/// readShotList(), with the file's name.
Result<std::vector<Shot>> selectedShots(const Project& project, const ShotOptions& options, const CliContext& context);

}  // namespace rubble
