#pragma once

#include "core/asset/BakeDifference.h"
#include "core/asset/RecipeDifference.h"

namespace rubble {

/// An asset in two states of a project; null where a state does not have it.
struct AssetPair {
    const Asset* before = nullptr;
    const Asset* after = nullptr;

    /// As it is called now, or was.
    const std::string& name() const { return (after ? after : before)->name; }
};

/// Which assets of two states are the same: those of one name, then, of what is left, those of one id, which were renamed. In
/// the later state's order, then what is gone in the earlier one's. They point into the projects.
std::vector<AssetPair> assetPairs(const Project& before, const Project& after);

/// What became of one asset between two states of a project.
struct AssetDifference {
    AssetPair pair;
    std::vector<RecipeChange> recipe;  // empty where a state does not have the asset
    BakeDifference pieces;             // one without the asset has no pieces

    bool isNone() const { return pair.before && pair.after && recipe.empty() && pieces.isNone(); }
};

/// Bakes both states of an asset, side by side, and compares them. What differs in neither recipe nor pieces is none.
///
/// Errors: those of bake().
Result<AssetDifference> differenceOf(const Project& before, const Project& after, const AssetPair& pair,
                                     const TaskContext& task = {});

/// How many fragments there are, and what became of them: "20 fragments, were 18: 3 gone, 5 added, 4 moved, 2 reshaped".
std::string sentenceOf(const LevelDifference& level);
/// One fragment: "5.17 moved by 12 mm, now 0.0012 m^3, was 0.0013 m^3".
std::string sentenceOf(const PieceDifference& piece);

}  // namespace rubble
