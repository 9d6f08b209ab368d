#include "editor/background/ComparedAsset.h"

#include "core/io/project/ProjectDifference.h"

#include <algorithm>

namespace rubble {

namespace {

/// The asset in the earlier state; null if it did not exist.
const Asset* earlierOf(const Asset& asset, const Project& earlier, const Project& now) {
    const std::vector<AssetPair> pairs = assetPairs(earlier, now);
    const auto pair = std::ranges::find(pairs, &asset, &AssetPair::after);
    return pair != pairs.end() ? pair->before : nullptr;
}

}  // namespace

Result<std::shared_ptr<const ComparedAsset>> comparedAsset(const Project& earlier, std::shared_ptr<const Bake> before,
                                                           const Project& now, std::shared_ptr<const Bake> after,
                                                           const TaskContext& task) {
    ComparedAsset compared;
    compared.after = std::move(after);
    const Asset& asset = *findAsset(now, compared.after->asset);
    const Asset* const earlierAsset = earlierOf(asset, earlier, now);
    if (earlierAsset == nullptr) return std::make_shared<const ComparedAsset>(std::move(compared));
    compared.existedBefore = true;
    compared.recipe = assetChanges(earlier, *earlierAsset, now, asset);
    compared.before = std::move(before);
    if (!compared.before || compared.before->asset != earlierAsset->id) {
        Result<Bake> made = bake(*earlierAsset, {.cancel = task.cancel});
        if (!made) return made.error();
        compared.before = std::make_shared<const Bake>(std::move(*made));
    }
    compared.fragments = differenceOf(*compared.before, *compared.after);
    return std::make_shared<const ComparedAsset>(std::move(compared));
}

}  // namespace rubble
