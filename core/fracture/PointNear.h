#pragma once

#include "core/base/Random.h"
#include "core/geometry/Polygon.h"

#include <optional>

namespace rubble {

/// A random point of an outline within `radius` of a centre, denser towards it: as many within a half of the radius as beyond
/// it. None where fifty throws all miss the outline. `centre` may lie outside.
std::optional<Vec2> pointNear(const Polygon& outline, Vec2 centre, double radius, Random& random);

}  // namespace rubble
