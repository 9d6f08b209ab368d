#pragma once

#include "core/base/Random.h"
#include "core/geometry/hull/Polytope.h"
#include "tests/support/geometry/Outlines.h"

#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>

namespace rubble::test {

/// A box between two corners.
inline Polytope boxBetween(Vec3 min, Vec3 max) {
    return extruded(rectangle({min.x, min.y}, {max.x, max.y}), min.z, max.z);
}

inline Pose randomPose(Random& random) {
    const auto part = [&] { return random.between(-1.0, 1.0); };
    return {10.0 * Vec3{part(), part(), part()}, glm::normalize(Quat{1.0 + part(), part(), part(), part()})};
}

}  // namespace rubble::test
