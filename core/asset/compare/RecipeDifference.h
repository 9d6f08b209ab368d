#pragma once

#include "core/asset/project/Project.h"

#include <string>
#include <vector>

namespace rubble {

/// One changed setting of an asset as text: {"threshold", "900 N·s", "1200 N·s"}.
struct RecipeChange {
    std::string what;    // "outline", "threshold", "layer 5 (uniform), count"
    std::string before;  // empty if it is new
    std::string after;   // empty if it was removed
    bool operator==(const RecipeChange&) const = default;
};

/// All changed settings of an asset, in the order of Asset's members: name, outline, depth, materials (by name and
/// density), threshold, layers of all levels (matched by id), shaping, edits, surface. assetChanges() in core/io finds
/// what is not described here.
std::vector<RecipeChange> recipeChanges(const Project& before, const Asset& earlier, const Project& after,
                                        const Asset& later);

/// The change as a sentence: "threshold: 900 N·s, was 1200 N·s"; "layer 5 (uniform) added: count 20", "layer 5
/// (uniform) removed: count 20".
std::string sentenceOf(const RecipeChange& change);

}  // namespace rubble
