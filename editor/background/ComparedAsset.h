#pragma once

#include "core/asset/compare/AssetDifference.h"
#include "core/asset/project/Project.h"
#include "core/base/TaskContext.h"

#include <memory>
#include <vector>

namespace rubble {

/// The active asset in an earlier state of the project and now.
struct ComparedAsset {
    bool existedBefore = false;  // in the earlier state; else the following three are empty
    std::vector<RecipeChange> recipe;
    BakeDifference fragments;
    std::shared_ptr<const Bake> before;
    std::shared_ptr<const Bake> after;

    bool isEmpty() const { return existedBefore && recipe.empty() && fragments.isEmpty(); }
};

/// Compares a bake of a project with its asset in an earlier state, of which `before` may be a bake already; null or of
/// another asset: it is baked.
///
/// Errors: those of bake().
Result<std::shared_ptr<const ComparedAsset>> comparedAsset(const Project& earlier, std::shared_ptr<const Bake> before,
                                                           const Project& now, std::shared_ptr<const Bake> after,
                                                           const TaskContext& task);

}  // namespace rubble
