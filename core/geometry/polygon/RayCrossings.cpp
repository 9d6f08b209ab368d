#include "core/geometry/polygon/RayCrossings.h"

#include "core/geometry/predicates/Predicates.h"

#include <algorithm>

namespace rubble {

void RayCrossings::add(Vec2 from, Vec2 to, Vec2 point) {
    if (std::max(from.y, to.y) < point.y || std::min(from.y, to.y) > point.y) return;
    const int side = orient2d(from, to, point);
    if (side == 0 && std::min(from.x, to.x) <= point.x && point.x <= std::max(from.x, to.x)) {
        isOnEdge = true;
        return;
    }
    const bool goesUp = from.y <= point.y && to.y > point.y;
    const bool goesDown = to.y <= point.y && from.y > point.y;
    if ((goesUp && side > 0) || (goesDown && side < 0)) isOdd = !isOdd;
}

}  // namespace rubble
