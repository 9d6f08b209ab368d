#pragma once

#include "core/physics/narrowphase/Manifold.h"

namespace rubble {

/// The distance below which hulls get a manifold before they touch (speculative contacts), so that they do not overlap
/// first.
inline constexpr float kSpeculativeDistance = 0.02f;  // m

/// The result of colliding two hulls.
struct HullCollision {
    Manifold manifold;  // in the first hull's frame
    SeparatingAxis axis;
    Vec3f offset{0.0f, 0.0f,
                 0.0f};    // m: the second's centre of mass for which the manifold holds, in the first's frame
    bool isSwept = false;  // whether the manifold is that of the time of impact
};

/// Collides two hulls; the manifold is empty if they are more than `margin` apart. `guess` is the axis of the last
/// collision, which is kept unless another separates the hulls by clearly more; `turn` as for manifoldAlong().
HullCollision collideHulls(const Hull& first, const Hull& second, const RelativePose& pose, float margin,
                           const SeparatingAxis& guess, Vec3f turn = Vec3f(0.0f));

}  // namespace rubble
