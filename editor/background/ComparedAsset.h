#pragma once

#include "core/asset/compare/AssetDifference.h"

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

}  // namespace rubble
