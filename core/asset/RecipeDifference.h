#pragma once

#include "core/asset/Project.h"

#include <string>
#include <vector>

namespace rubble {

/// One thing that an asset says otherwise in a later state, in words: {"threshold", "900 N s", "1200 N s"}.
struct RecipeChange {
    std::string what;    // "outline", "threshold", "layer 5 (uniform), count"
    std::string before;  // empty where it was not there
    std::string after;   // empty where it is not there any more
    bool operator==(const RecipeChange&) const = default;
};

/// All that an asset says otherwise than it did, in the order of Asset's members: name, outline, depth, materials (by their names
/// and what bodies feel of them), threshold, layers of all levels (found by id), shaping, edits. Empty where both say the same.
std::vector<RecipeChange> recipeChanges(const Project& before, const Asset& earlier, const Project& after,
                                        const Asset& later);

/// "threshold: 900 N s, was 1200 N s"; "layer 5 (uniform) is new: count 20", "layer 5 (uniform) is gone".
std::string sentenceOf(const RecipeChange& change);

}  // namespace rubble
