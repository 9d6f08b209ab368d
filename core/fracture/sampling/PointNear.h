#pragma once

#include "core/base/Random.h"
#include "core/geometry/polygon/Polygon.h"

#include <optional>

namespace rubble {

/// A random point of an outline within `radius` of a centre: its distance is uniformly distributed, so that half of the
/// points lie within half the radius. Nothing if fifty attempts all miss the outline. `centre` may lie outside.
std::optional<Vec2> pointNear(const Polygon& outline, Vec2 centre, double radius, Random& random);

}  // namespace rubble
