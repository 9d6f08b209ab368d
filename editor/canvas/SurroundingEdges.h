#pragma once

#include "core/asset/Bake.h"

#include <array>
#include <vector>

namespace rubble {

/// The edges of all that a fragment was broken out of, level by level, each once, in the fragment's frame, m: what is seen around
/// one that one is inside. None where the bake does not have it.
std::vector<std::array<Vec2, 2>> edgesAround(const Bake& bake, const FragmentPath& fragment);

}  // namespace rubble
