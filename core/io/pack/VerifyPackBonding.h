#pragma once

#include "core/io/pack/PackFile.h"

#include <optional>
#include <string>

namespace rubble {

/// Returns the first error in the bonds of a pack, if it has any and there is one. The bonds of a body are those of
/// neighbouring fragments of it, each pair once and with the area of their contact; they ascend, and so do the bodies.
/// Centroids lie in the whole, normals have length 1, capacities are not negative, and fragments of the whole are
/// anchored. Precondition: parents and neighbours are valid. O(n log n).
std::optional<std::string> verifyPackBonding(const Pack& pack);

}  // namespace rubble
