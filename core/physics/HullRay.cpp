#include "core/physics/HullRay.h"

#include <algorithm>

namespace rubble {

HullEntry entryOf(const Hull& hull, Vec3f from, Vec3f way) {
    float begin = -1.0f, end = 1.0f;
    HullEntry entry;
    for (const HullPlane& plane : hull.planes) {
        const float above = dot(plane.normal, from) - plane.offset, speed = dot(plane.normal, way);
        if (speed == 0.0f) {
            if (above > 0.0f) return {};
            continue;
        }
        const float share = -above / speed;
        if (speed < 0.0f && share > begin) {
            begin = share;
            entry = {share, plane.normal};
        }
        if (speed > 0.0f) end = std::min(end, share);
    }
    return begin >= 0.0f && begin <= end ? entry : HullEntry{};
}

}  // namespace rubble
