#pragma once

#include "core/asset/bake/Bake.h"
#include "core/asset/project/Project.h"

#include <vector>

namespace rubble {

/// The colour of fragments in no cluster: a grey on which dark and light lines can be seen.
inline constexpr Colour kUnclusteredColour{0.62, 0.62, 0.62};

/// A colour for each fragment of a fracture by its clusters: the hue follows from its coarsest cluster, the lightness
/// from the deepest of several. Fragments of the same clusters have the same colour.
std::vector<Colour> clusterColours(const Asset& asset, const Bake& bake, std::uint32_t fracture);

}  // namespace rubble
