#pragma once

#include "core/asset/project/Project.h"
#include "core/base/Result.h"

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace rubble {

/// Adds --asset, which is repeatable, to a verb.
void addAssetOption(CLI::App& command, std::vector<std::string>& names);

/// Returns the assets with these names, in the project's order; all if `names` is empty.
///
/// Errors: NotFound, with the first unknown name and the names of all assets.
Result<std::vector<Id>> selectedAssets(const Project& project, const std::vector<std::string>& names);

}  // namespace rubble
