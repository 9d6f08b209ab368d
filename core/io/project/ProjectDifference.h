#pragma once

#include "core/asset/compare/AssetDifference.h"

#include <span>
#include <vector>

namespace rubble {

/// All changed settings of an asset: recipeChanges(), then every other value of its JSON that differs. Empty if both
/// states are equal.
std::vector<RecipeChange> assetChanges(const Project& before, const Asset& earlier, const Project& after,
                                       const Asset& later);

/// All changed values of a project outside its assets: materials, instances, ground, gravity, damage, debris, events,
/// shots and play-tests. Found in the JSON of both states, so that no value is forgotten. Elements are matched by their
/// ids, the rest by their names. The next id counts only where nothing else differs, assets included.
std::vector<RecipeChange> settingChanges(const Project& before, const Project& after);

/// The differences between two states of a project.
struct ProjectDifference {
    std::vector<AssetDifference> assets;  // of all pairs that were compared, equal ones included
    std::vector<RecipeChange> settings;   // settingChanges(); empty if only some assets were compared

    bool isEmpty() const;
};

/// Compares pairs of assets, with assetChanges() as their recipes; `settings` is left empty.
///
/// Errors: those of bake().
Result<ProjectDifference> projectDifference(const Project& before, const Project& after,
                                            std::span<const AssetPair> pairs, const TaskContext& task = {});

}  // namespace rubble
