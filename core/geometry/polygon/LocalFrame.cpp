#include "core/geometry/polygon/LocalFrame.h"

#include <algorithm>

namespace rubble {

namespace {

/// An origin that can be subtracted from the outline without rounding: 0 on each axis unless the outline is farther
/// from it than it is wide, where all its coordinates are within a factor of two (Sterbenz).
Vec2 exactOrigin(const Polygon& outline) {
    const Box2 box = boundsOf(outline.outer);
    const auto isFar = [](double min, double max) {
        return std::min(std::abs(min), std::abs(max)) >= max - min && min * max > 0.0;
    };
    return {isFar(box.min.x, box.max.x) ? outline.outer[0].x : 0.0,
            isFar(box.min.y, box.max.y) ? outline.outer[0].y : 0.0};
}

}  // namespace

LocalFrame localFrame(const Polygon& outline) {
    LocalFrame frame;
    frame.origin = exactOrigin(outline);
    for (const Vec2 point : outline.outer) {
        frame.extent = std::max({frame.extent, std::abs(point.x - frame.origin.x), std::abs(point.y - frame.origin.y)});
    }
    frame.weldDistance = kWeldFraction * frame.extent;
    return frame;
}

}  // namespace rubble
