#include "core/physics/narrowphase/HullRay.h"

#include <algorithm>

namespace rubble {

HullRayHit castRay(const Hull& hull, Vec3f from, Vec3f displacement) {
    float begin = -1.0f, end = 1.0f;
    HullRayHit entry;
    for (const HullPlane& plane : hull.planes) {
        const float above = dot(plane.normal, from) - plane.offset, speed = dot(plane.normal, displacement);
        if (speed == 0.0f) {
            if (above > 0.0f) return {};
            continue;
        }
        const float fraction = -above / speed;
        if (speed < 0.0f && fraction > begin) {
            begin = fraction;
            entry = {fraction, plane.normal};
        }
        if (speed > 0.0f) end = std::min(end, fraction);
    }
    return begin >= 0.0f && begin <= end ? entry : HullRayHit{};
}

}  // namespace rubble
