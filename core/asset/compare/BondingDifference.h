#pragma once

#include "core/asset/compare/RecipeDifference.h"

#include <vector>

namespace rubble {

/// What differs in how two states of an asset break, whole or as bonded, except for the bond strengths of their levels.
std::vector<RecipeChange> bondingChanges(const Asset& before, const Asset& after);

}  // namespace rubble
