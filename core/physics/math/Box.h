#pragma once

#include "core/physics/math/Vec3f.h"

namespace rubble {

/// An axis-aligned bounding box in single precision.
struct Box {
    Vec3f low{0.0f, 0.0f, 0.0f};
    Vec3f high{0.0f, 0.0f, 0.0f};

    bool overlaps(const Box& other) const {
        // Without short-circuiting: which of the six comparisons fails is unpredictable.
        const int below = (low.x <= other.high.x) & (low.y <= other.high.y) & (low.z <= other.high.z);
        const int above = (other.low.x <= high.x) & (other.low.y <= high.y) & (other.low.z <= high.z);
        return (below & above) != 0;
    }
    bool contains(const Box& other) const {
        return low.x <= other.low.x && low.y <= other.low.y && low.z <= other.low.z && other.high.x <= high.x &&
               other.high.y <= high.y && other.high.z <= high.z;
    }
    /// Half the surface area, m².
    float halfSurfaceArea() const {
        const Vec3f side = high - low;
        return side.x * side.y + side.y * side.z + side.z * side.x;
    }
    Vec3f middle() const { return (low + high) * 0.5f; }
};

inline Box joined(const Box& a, const Box& b) { return {componentMin(a.low, b.low), componentMax(a.high, b.high)}; }
inline Box widened(const Box& box, float margin) { return {box.low - Vec3f(margin), box.high + Vec3f(margin)}; }
/// The bounds of a box moving along a displacement.
inline Box swept(const Box& box, Vec3f displacement) {
    const Vec3f none(0.0f);
    return {box.low + componentMin(displacement, none), box.high + componentMax(displacement, none)};
}

}  // namespace rubble
