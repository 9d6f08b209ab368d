#pragma once

#include "core/physics/SeparatingAxis.h"

namespace rubble {

/// Where a hull that moves without turning meets another that stands still; in the frame of the first, which moves along.
struct HullMeeting {
    float fraction = 2.0f;  // of the way; beyond 1 where they do not meet, 0 where they touch or overlap from the start
    Vec3f point{0.0f, 0.0f, 0.0f};
    Vec3f normal{0.0f, 0.0f, 0.0f};  // from the second to the first, length 1
};

/// `place` is where the second is at the start, `way` how far the first goes.
HullMeeting meetingOf(const Hull& first, const Hull& second, const RelativePlace& place, Vec3f way);

}  // namespace rubble
