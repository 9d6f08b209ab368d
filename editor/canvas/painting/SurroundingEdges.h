#pragma once

#include "core/asset/bake/Bake.h"

#include <array>
#include <vector>

namespace rubble {

/// The edges of all fragments around an entered fragment, level by level, each once, in the fragment's frame, m. Empty
/// if the bake does not contain the fragment.
std::vector<std::array<Vec2, 2>> surroundingEdges(const Bake& bake, const FragmentPath& fragment);

}  // namespace rubble
