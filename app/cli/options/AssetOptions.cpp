#include "app/cli/options/AssetOptions.h"

#include "app/cli/options/CommonOptions.h"

#include <CLI/CLI.hpp>

#include <algorithm>

namespace rubble {
void addAssetOption(CLI::App& command, std::vector<std::string>& names) {
    command.add_option("--asset", names, "Only this asset; repeatable")->expected(1)->take_all()->option_text("NAME");
}

Result<std::vector<Id>> selectedAssets(const Project& project, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        if (findAsset(project, name) != nullptr) continue;
        return Error{ErrorCode::NotFound,
                     "The project has no asset \"" + name + "\"; " + quotedNamesOf(project.assets) + "."};
    }
    std::vector<Id> selected;
    for (const Asset& asset : project.assets) {
        if (names.empty() || std::ranges::find(names, asset.name) != names.end()) selected.push_back(asset.id);
    }
    return selected;
}

}  // namespace rubble
