#include "core/asset/bake/AssetBakes.h"

#include "core/asset/bake/BakeEstimate.h"
#include "core/asset/project/Ids.h"
#include "core/base/Parallel.h"

#include <optional>

namespace rubble {

Result<AssetBakes> bakesOf(const Project& project, std::span<const Id> only, const TaskContext& task) {
    std::vector<AssetVariant> variants = usedVariants(project);
    std::erase_if(variants,
                  [&](const AssetVariant& variant) { return !only.empty() && !isAmong(only, variant.asset); });
    double bytes = 0.0;
    for (const AssetVariant& variant : variants) bytes += estimateOf(*findAsset(project, variant.asset)).bytes();
    if (const std::optional<std::string> fault = totalSizeFault(variants.size(), bytes))
        return Error{ErrorCode::Limit, *fault};
    std::vector<std::optional<Result<Bake>>> results(variants.size());
    forEachIndex(variants.size(), task.threads, [&](std::size_t index) {
        const auto [asset, variant] = variants[index];
        results[index] = bake(variantOf(*findAsset(project, asset), variant), {.cancel = task.cancel});
    });
    AssetBakes bakes;
    for (std::size_t k = 0; k < variants.size(); ++k) {
        Result<Bake>& result = *results[k];
        if (!result) return result.error();
        bakes[variants[k]] = std::make_shared<const Bake>(std::move(*result));
    }
    return bakes;
}

}  // namespace rubble
