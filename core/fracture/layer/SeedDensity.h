#pragma once

#include "core/geometry/predicates/Vec.h"

#include <functional>

namespace rubble {

/// A density of seeds at a point, in any unit.
using SeedDensity = std::function<double(Vec2)>;

}  // namespace rubble
