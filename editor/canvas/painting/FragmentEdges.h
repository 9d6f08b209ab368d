#pragma once

#include "core/asset/bake/Bake.h"

#include <array>
#include <vector>

namespace rubble {

/// The edges of all fragments around an entered fragment, level by level, each once, in the fragment's frame, m. Empty
/// if the bake does not contain the fragment.
std::vector<std::array<Vec2, 2>> surroundingEdges(const Bake& bake, const FragmentPath& fragment);

/// The edges of all levels below the fragments of a fragment (the whole asset for the empty path), in its frame, m.
std::vector<std::array<Vec2, 2>> deeperEdges(const Bake& bake, const FragmentPath& fragment);

/// The fragments that a fragment (the whole asset for the empty path) is fractured into; null if it is not, or if the
/// bake does not contain it.
const Fragments* fragmentsWithin(const Bake& bake, const FragmentPath& fragment);

}  // namespace rubble
