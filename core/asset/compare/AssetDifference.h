#pragma once

#include "core/asset/compare/BakeDifference.h"
#include "core/asset/compare/RecipeDifference.h"

namespace rubble {

/// An asset in two states of a project; null in a state without it.
struct AssetPair {
    const Asset* before = nullptr;
    const Asset* after = nullptr;

    /// The later name.
    const std::string& name() const { return (after ? after : before)->name; }
};

/// Matches the assets of two states by name, then the rest by id, since these were renamed. In the later state's order,
/// then the removed assets in the earlier one's. Points into the projects.
std::vector<AssetPair> assetPairs(const Project& before, const Project& after);

/// The differences of one asset between two states of a project.
struct AssetDifference {
    AssetPair pair;
    std::vector<RecipeChange> recipe;  // empty if a state does not have the asset
    BakeDifference fragments;          // a state without the asset has no fragments

    /// True if recipe and fragments are equal.
    bool isEmpty() const { return pair.before && pair.after && recipe.empty() && fragments.isEmpty(); }
};

/// Bakes both states of an asset in parallel and compares them.
///
/// Errors: those of bake().
Result<AssetDifference> differenceOf(const Project& before, const Project& after, const AssetPair& pair,
                                     const TaskContext& task = {});

/// The changes as a sentence: "20 fragments, were 18: 3 removed, 5 added, 4 moved, 2 reshaped".
std::string sentenceOf(const LevelDifference& level);
/// The change as a sentence: "5.17 moved by 12 mm, now 0.0012 m³, was 0.0013 m³".
std::string sentenceOf(const FragmentDifference& fragment);

}  // namespace rubble
