#pragma once

#include "core/base/Random.h"
#include "core/fracture/sampling/SolidDomain.h"
#include "core/geometry/polygon/Polygon.h"

#include <optional>

namespace rubble {

/// A random point of an outline within `radius` of a centre: its distance is uniformly distributed, so that half of the
/// points lie within half the radius. Nothing if fifty attempts all miss the outline. `centre` may lie outside.
std::optional<Vec2> pointNear(const Polygon& outline, Vec2 centre, double radius, Random& random);

/// The same in a closed mesh. If fifty attempts miss, as in a thin one, the point is uniform within a ball of random
/// radius; nothing if there is no room in that.
std::optional<Vec3> pointNear(const SolidDomain& domain, Vec3 centre, double radius, Random& random);

}  // namespace rubble
