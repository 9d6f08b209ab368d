#include "core/geometry/PointFrame.h"

#include <algorithm>

namespace rubble {

namespace {

/// An origin that can be subtracted from the outline without rounding: an axis keeps 0 unless the outline lies farther
/// from it than it is wide, and then all its coordinates are within a factor of two of each other.
Vec2 exactOrigin(const Polygon& outline) {
    const Box2 box = boundsOf(outline.outer);
    const auto isFar = [](double min, double max) {
        return std::min(std::abs(min), std::abs(max)) >= max - min && min * max > 0.0;
    };
    return {isFar(box.min.x, box.max.x) ? outline.outer[0].x : 0.0,
            isFar(box.min.y, box.max.y) ? outline.outer[0].y : 0.0};
}

}  // namespace

PointFrame frameOf(const Polygon& outline) {
    PointFrame frame;
    frame.origin = exactOrigin(outline);
    for (const Vec2 point : outline.outer) {
        frame.reach = std::max({frame.reach, std::abs(point.x - frame.origin.x), std::abs(point.y - frame.origin.y)});
    }
    frame.joinDistance = kJoinedPart * frame.reach;
    return frame;
}

}  // namespace rubble
