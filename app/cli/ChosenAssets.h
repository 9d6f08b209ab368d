#pragma once

#include "core/asset/Project.h"
#include "core/base/Result.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace rubble {

/// Adds --asset, which may be given several times, to a verb.
void addAssetOption(CLI::App& command, std::vector<std::string>& names);

/// The assets with these names, in the project's order and each once; all where there is no name.
///
/// Errors: NotFound, naming the first name that no asset has and the names that there are.
Result<std::vector<Id>> chosenAssets(const Project& project, const std::vector<std::string>& names);

}  // namespace rubble
