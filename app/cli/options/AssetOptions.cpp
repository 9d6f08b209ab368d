#include "app/cli/options/AssetOptions.h"

#include "app/cli/options/Command.h"
#include "app/cli/options/CommonOptions.h"
#include "app/cli/output/ProjectLoading.h"
#include "core/base/MessageText.h"
#include "core/io/project/ProjectFile.h"
#include "core/io/project/ProjectLock.h"

#include <algorithm>

namespace rubble {

void addAssetOption(Command& command, std::vector<std::string>& names) {
    command.option("-a,--asset", names, "Only this asset; repeatable").repeatable().valueName("NAME");
}

Result<std::vector<Id>> selectedAssets(const Project& project, const std::vector<std::string>& names) {
    for (const std::string& name : names) {
        if (findAsset(project, name) != nullptr) continue;
        return Error{ErrorCode::NotFound,
                     "The project has no asset " + quotedName(name) + "; " + quotedNamesOf(project.assets) + "."};
    }
    std::vector<Id> selected;
    for (const Asset& asset : project.assets) {
        if (names.empty() || std::ranges::find(names, asset.name) != names.end()) selected.push_back(asset.id);
    }
    return selected;
}

Result<ProjectAssets> loadProjectAssets(const std::string& file, const std::vector<std::string>& names,
                                        const CliContext& context) {
    Result<Project> project = openProject(file, context);
    if (!project) return project.error();
    Result<std::vector<Id>> assets = selectedAssets(*project, names);
    if (!assets) return assets.error();
    if (assets->empty()) return Error{ErrorCode::NotFound, "The project has no assets."};
    return ProjectAssets{std::move(*project), std::move(*assets)};
}

Status changeAsset(const std::filesystem::path& file, const std::string& name, const CliContext& context,
                   const std::function<Status(Project& project, Asset& asset)>& change) {
    const Result<std::shared_ptr<const LockFile>> lock = waitForProjectLock(file, context.cancel);
    if (!lock) return lock.error();
    Result<Project> project = openProject(file, context);
    if (!project) return project.error();
    const Result<std::vector<Id>> selected = selectedAssets(*project, {name});
    if (!selected) return selected.error();
    Asset& asset = *std::ranges::find(project->assets, selected->front(), &Asset::id);
    if (const Status changed = change(*project, asset); !changed) return changed;
    return saveProject(file, *project);
}

}  // namespace rubble
