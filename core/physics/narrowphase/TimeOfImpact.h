#pragma once

#include "core/physics/narrowphase/SeparatingAxis.h"

namespace rubble {

/// The time at which two hulls that move without rotating begin to touch.
struct TimeOfImpact {
    SeparatingAxis axis;    // along which they touch, with separation 0; kind None where they do not
    float fraction = 1.0f;  // of the displacement, in [0, 1]
};

/// The time of impact of two hulls where the second moves by `displacement`, m, relative to the first, in the first's
/// frame; none if they touch or overlap at the start.
/// Source: Eberly 2001, "Dynamic collision detection".
TimeOfImpact timeOfImpact(const Hull& first, const Hull& second, const RelativePose& pose, Vec3f displacement);

}  // namespace rubble
