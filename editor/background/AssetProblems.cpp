#include "editor/background/AssetProblems.h"

#include "core/play/scene/SupportProblems.h"

#include <algorithm>
#include <iterator>

namespace rubble {

Result<std::map<Id, AssetProblems>> problemsByAsset(const Project& project,
                                                    const std::map<Id, std::shared_ptr<const BakedAsset>>& baked,
                                                    const AssetBakes& sceneBakes,
                                                    const std::map<Id, AssetProblems>& earlier,
                                                    const TaskContext& task) {
    std::vector<Diagnostic> ofScene;
    if (!sceneBakes.empty()) ofScene = sceneProblems(project, sceneBakes, task);
    std::map<Id, AssetProblems> found;
    for (const auto& [id, one] : baked) {
        if (task.isCancelled()) return TaskContext::cancelled();
        const Asset* asset = findAsset(project, id);
        if (asset == nullptr) continue;
        AssetProblems& problems = found[id];
        problems.baked = one;
        if (const auto known = earlier.find(id); known != earlier.end() && known->second.baked == one) {
            problems.ofBake = known->second.ofBake;
        } else {
            problems.ofBake = one->bake ? problemsOf(*one->asset, *one->bake, {}, task) : outlineProblems(*one->asset);
        }
        problems.all = problems.ofBake;
        std::ranges::move(strengthProblems(*asset, *findMaterial(project, asset->material)),
                          std::back_inserter(problems.all));
        std::ranges::copy_if(ofScene, std::back_inserter(problems.all),
                             [id](const Diagnostic& problem) { return problem.place.asset == id; });
    }
    return found;
}

}  // namespace rubble
