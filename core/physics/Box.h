#pragma once

#include "core/physics/Vec3f.h"

namespace rubble {

/// A box along the axes.
struct Box {
    Vec3f low{0.0f, 0.0f, 0.0f};
    Vec3f high{0.0f, 0.0f, 0.0f};

    bool overlaps(const Box& other) const {
        // Without a branch after each: which of the six fails first cannot be foreseen.
        const int below = (low.x <= other.high.x) & (low.y <= other.high.y) & (low.z <= other.high.z);
        const int above = (other.low.x <= high.x) & (other.low.y <= high.y) & (other.low.z <= high.z);
        return (below & above) != 0;
    }
    bool contains(const Box& other) const {
        return low.x <= other.low.x && low.y <= other.low.y && low.z <= other.low.z && other.high.x <= high.x &&
               other.high.y <= high.y && other.high.z <= high.z;
    }
    /// Half its surface, m^2.
    float area() const {
        const Vec3f side = high - low;
        return side.x * side.y + side.y * side.z + side.z * side.x;
    }
    Vec3f middle() const { return (low + high) * 0.5f; }
};

inline Box joined(const Box& a, const Box& b) { return {leastOf(a.low, b.low), greatestOf(a.high, b.high)}; }
inline Box widened(const Box& box, float margin) { return {box.low - Vec3f(margin), box.high + Vec3f(margin)}; }
/// All that a box passes over on its way.
inline Box swept(const Box& box, Vec3f way) {
    const Vec3f none(0.0f);
    return {box.low + leastOf(way, none), box.high + greatestOf(way, none)};
}

}  // namespace rubble
