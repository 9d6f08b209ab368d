#pragma once

#include "core/physics/narrowphase/TimeOfImpact.h"

namespace rubble {

/// The point at which a hull that moves without rotating hits a fixed one, in the moving frame of the first.
struct HullCastHit {
    float fraction = 2.0f;  // of the displacement; above 1 if they miss, 0 if they touch or overlap at the start
    Vec3f point{0.0f, 0.0f, 0.0f};
    Vec3f normal{0.0f, 0.0f, 0.0f};  // from the second to the first, length 1
};

/// Casts the first hull by `displacement`; `pose` is the second's at the start.
HullCastHit castHull(const Hull& first, const Hull& second, const RelativePose& pose, Vec3f displacement);

}  // namespace rubble
