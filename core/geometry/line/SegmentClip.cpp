#include "core/geometry/line/SegmentClip.h"

#include <algorithm>

namespace rubble {

std::optional<std::array<Vec2, 2>> clippedTo(const Box2& box, Vec2 from, Vec2 to) {
    double first = 0.0, last = 1.0;
    const auto cut = [&](double start, double step, double low, double high) {
        if (step == 0.0) {
            if (start < low || start > high) last = -1.0;
            return;
        }
        const double atLow = (low - start) / step, atHigh = (high - start) / step;
        first = std::max(first, std::min(atLow, atHigh));
        last = std::min(last, std::max(atLow, atHigh));
    };
    const Vec2 along = to - from;
    cut(from.x, along.x, box.min.x, box.max.x);
    cut(from.y, along.y, box.min.y, box.max.y);
    if (first > last) return std::nullopt;
    return std::array{from + first * along, from + last * along};
}

}  // namespace rubble
