#pragma once

#include "core/asset/project/Project.h"
#include "core/base/Result.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace rubble {

class Command;
struct CliContext;

/// Adds --asset, which is repeatable, to a verb.
void addAssetOption(Command& command, std::vector<std::string>& names);

/// A project and assets of it.
struct ProjectAssets {
    Project project;
    std::vector<Id> assets;
};

/// Returns the assets with these names, in the project's order; all if `names` is empty.
///
/// Errors: NotFound, with the first unknown name and the names of all assets.
Result<std::vector<Id>> selectedAssets(const Project& project, const std::vector<std::string>& names);

/// Loads a project as openProject() does and selects its assets with these names; all if `names` is empty.
///
/// Errors: those of openProject() and selectedAssets(); NotFound if the project has no assets.
Result<ProjectAssets> loadProjectAssets(const std::string& file, const std::vector<std::string>& names,
                                        const CliContext& context);

/// Changes an asset of a project in its file, which is locked meanwhile, by change(project, asset).
///
/// Errors: those of waitForProjectLock(), openProject(), selectedAssets(), `change` and saveProject().
Status changeAsset(const std::filesystem::path& file, const std::string& name, const CliContext& context,
                   const std::function<Status(Project& project, Asset& asset)>& change);

}  // namespace rubble
