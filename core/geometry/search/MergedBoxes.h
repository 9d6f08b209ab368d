#pragma once

#include "core/geometry/search/Box3.h"

#include <vector>

namespace rubble {

/// Replaces boxes that overlap or touch by the box around them, until no two do. Empty boxes are dropped; the result
/// is sorted by x, y, z of the lower corners and does not depend on the order of `boxes`.
///
/// O(n log n) a round for n boxes of which few overlap along x; a round follows another only where boxes were merged.
std::vector<Box3> mergedBoxes(std::vector<Box3> boxes);

}  // namespace rubble
