#include "core/asset/AssetBakes.h"

#include "core/base/Parallel.h"

#include <algorithm>
#include <optional>

namespace rubble {

Result<AssetBakes> bakesOf(const Project& project, std::span<const Id> only, const TaskContext& task) {
    std::vector<const Asset*> assets;
    for (const Asset& asset : project.assets) {
        if (only.empty() || std::ranges::find(only, asset.id) != only.end()) assets.push_back(&asset);
    }
    std::vector<std::optional<Result<Bake>>> results(assets.size());
    forEachIndex(assets.size(), task.threads,
                 [&](std::size_t index) { results[index] = bake(*assets[index], {.cancel = task.cancel}); });
    AssetBakes bakes;
    for (std::size_t k = 0; k < assets.size(); ++k) {
        Result<Bake>& result = *results[k];
        if (!result) return result.error();
        bakes[assets[k]->id] = std::make_shared<const Bake>(std::move(*result));
    }
    return bakes;
}

}  // namespace rubble
