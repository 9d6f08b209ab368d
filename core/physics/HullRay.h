#pragma once

#include "core/physics/Hull.h"

namespace rubble {

/// Where a segment enters a hull.
struct HullEntry {
    float fraction = 2.0f;  // of the segment; beyond 1 where it does not enter, or begins inside
    Vec3f normal{0.0f, 0.0f, 0.0f};
};

/// Both in the hull's frame; the segment goes from `from` to `from + way`.
/// Source: Cyrus, Beck 1978.
HullEntry entryOf(const Hull& hull, Vec3f from, Vec3f way);

}  // namespace rubble
